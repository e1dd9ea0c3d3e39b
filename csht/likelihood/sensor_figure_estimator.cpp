#include "csht/likelihood/sensor_figure_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"
#include "csht/likelihood/range_gate.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {
namespace {

// What is learnt beyond the paper's figures counts only when it is so many standard errors off.
constexpr double kSureSigmas = 2.0;
constexpr double kFewTails = 0.03;    // Share of wide errors below which errors count as Gaussian,
constexpr double kPriorTails = 20.0;  // and the weight, in returns, with which that is believed at first.
constexpr double kFewTrials = 20.0;   // No line is fitted through fewer misses and returns.
constexpr double kLeastMiss = 0.01, kMostMiss = 0.98;
constexpr double kHidden = 0.5;  // A target behind one that exists with more than this may have been hidden.

double square(double x) {
  return x * x;
}

// What became of a target in one scan, if a sampled trajectory is its.
struct Sighting {
  double reported = 0.0, silence = 0.0;  // Probability of a return of its own, and of a miss.
  double lost = 0.0;                     // Of a return that noise took out of the range gate.
  double residual = 0.0, range = 0.0;    // Of the return, and of the prediction [m].
  double narrow = 1.0;                   // Share of `reported` whose error was no wide one.
  double wide = 0.0, either = 0.0;       // Of a return of its own with a wide error, and with any.
};

// What sightings are told apart by: the P_M that the scan was laid out with, and the share of wide errors,
// whether or not it is in use.
struct Told {
  double miss = 0.0, tail_share = 0.0;
};

Sighting sight_in_beam(const ScanTable& scan, double range, double bearing, const Told& told) {
  const double beam = scan.beams_from_middle(bearing) + 0.5 * scan.num_beams;
  if (beam < 0.0 || beam >= scan.num_beams || range > scan.max_range) return {};
  const auto slot = static_cast<std::size_t>(beam) + 1;
  if (scan.silent(static_cast<int>(beam))) {
    const double heard = heard_share(scan.range_loss, range);
    const double out = scan.range_gate ? lost_share(scan.max_range, scan.inverse_sigma, range) : 0.0;
    const double lost = scan.lost[slot] * heard * out;
    const double miss = scan.base[slot] + scan.lost[slot] * (1.0 - heard), listened = scan.listened;
    return {0.0, listened * miss / (miss + lost), listened * lost / (miss + lost), 0.0, range};
  }
  const double residual = scan.range[slot] - range, sigmas = residual * scan.inverse_sigma;
  const double width = sigmas / SensorFigures::kTailScale, height = 1.0 / SensorFigures::kTailScale;
  const double narrow = std::exp(-0.5 * sigmas * sigmas), wide = height * std::exp(-0.5 * width * width);
  const double own = peak_of(scan, slot, range);
  const double both = (1.0 - told.tail_share) * narrow + told.tail_share * wide;
  const double all = scan.gain + scan.tail_gain * SensorFigures::kTailScale;
  const double either = all * scan.worth[slot] * heard_share(scan.range_loss, range) * both;
  // Where clutter is dense, a return that does not fit fills the place of one that was missed. Elsewhere it
  // is of something else, the trajectory or the model is wrong, and neither a detection nor a miss is learnt.
  const double filled =
      scan.lost[slot] * (told.miss / (1.0 - told.miss) + 1.0 - heard_share(scan.range_loss, range));
  const double total = own + scan.base[slot];
  Sighting sighting{own / total, std::min(filled, static_cast<double>(scan.base[slot])) / total, 0.0,
                    residual, range};
  sighting.narrow = both > 0.0 ? (1.0 - told.tail_share) * narrow / both : 1.0;
  sighting.either = either / (either + scan.base[slot]);
  sighting.wide = both > 0.0 ? sighting.either * told.tail_share * wide / both : 0.0;
  return sighting;
}

Sighting sight_of_point(const ScanTable& scan, double range, double bearing) {
  if (std::abs(bearing) > scan.half_sector || range > scan.max_range) return {};
  const double lost = scan.lost[1] * lost_share(scan.max_range, scan.inverse_sigma, range);
  double returns = 0.0, best = 0.0;
  Sighting sighting{0.0, 0.0, 0.0, 0.0, range};
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const double dr = scan.detections[j].range - range;
    const double db = core::wrap_to_pi(scan.bearing_from_axis[j] - bearing) * scan.inverse_bearing_sigma;
    const double sigmas = dr * scan.inverse_sigma;
    const double own = scan.gain * std::exp(-0.5 * (sigmas * sigmas + db * db));
    if (own > best) sighting.residual = dr;
    best = std::max(best, own);
    returns += own;
  }
  const double total = returns + scan.base[1] + lost;
  sighting.reported = returns / total;
  sighting.silence = scan.listened * scan.base[1] / total;
  sighting.lost = scan.listened * lost / total;
  return sighting;
}

Sighting sight(const ScanTable& scan, const Eigen::Vector4d& state, double seconds, const Told& told) {
  const double dn = state[0] + seconds * state[2] - scan.T_earth_sonar.north;
  const double de = state[1] + seconds * state[3] - scan.T_earth_sonar.east;
  const double bearing = core::wrap_to_pi(std::atan2(de, dn) - scan.axis);
  return scan.clutter == ClutterModel::point ? sight_of_point(scan, std::hypot(dn, de), bearing)
                                             : sight_in_beam(scan, std::hypot(dn, de), bearing, told);
}

// Whether a target may hide another, whose miss then teaches nothing: it is nearer in the same beam or, for a
// sensor without beams, closer to it than the resolution. Both positions are relative to the sonar.
bool hides(const ScanTable& scan, const Eigen::Vector2d& target, const Eigen::Vector2d& other) {
  if (scan.clutter == ClutterModel::point)
    return scan.inverse_resolution > 0.0F &&
           (target - other).norm() * static_cast<double>(scan.inverse_resolution) < 1.0;
  const double across = std::abs(other.x() * target.y() - other.y() * target.x()) / target.norm();
  const bool nearer = target.norm() < other.norm() && other.dot(target) > 0.0;
  const double bearing = core::wrap_to_pi(std::atan2(other.y(), other.x()) - scan.axis);
  return nearer && across < scan.width_at(scan.beams_from_middle(bearing)) * other.norm();
}

}  // namespace

double SensorFigureEstimator::Share::sigma() const {
  return std::sqrt(mean() * (1.0 - mean()) / (trials + 1.0));
}

void SensorFigureEstimator::Share::fade(double factor) {
  hits *= factor;
  trials *= factor;
}

SensorFigureEstimator::SensorFigureEstimator(const SensorFigureParams& params, const core::SonarParams& given)
    : params_(params), given_(given), figures_(figures_of(given)), num_beams_(given.num_beams) {
  core::require(params.memory_scans > 1.0, "memory_scans must be > 1", params.memory_scans);
  core::require(params.settle_scans >= 1, "settle_scans must be >= 1", params.settle_scans);
  core::require(params.sure_existence >= 0.0 && params.sure_existence <= 1.0,
                "sure_existence must be in [0, 1]", params.sure_existence);
  core::require(params.unknown_miss > 0.0 && params.unknown_miss < 1.0, "unknown_miss must be in (0, 1)",
                params.unknown_miss);
  core::require(params.unknown_false_alarm > 0.0 && params.unknown_false_alarm < 1.0,
                "unknown_false_alarm must be in (0, 1)", params.unknown_false_alarm);
  core::require(params.doubt_sigmas > 0.0, "doubt_sigmas must be > 0", params.doubt_sigmas);
  core::require(params.prior_weight > 0.0, "prior_weight must be > 0", params.prior_weight);
  core::require(params.sigma_weight > 0.0, "sigma_weight must be > 0", params.sigma_weight);
  const double weight = params.prior_weight;
  miss_ = {weight * params.unknown_miss, weight};
  if (!given.point_sensor()) false_alarm_ = {weight * params.unknown_false_alarm, weight};
  tail_ = {kPriorTails * kFewTails, kPriorTails};
  squares_ = params.sigma_weight * given.range_sigma * given.range_sigma;
  returns_ = params.sigma_weight;
  choose();
}

void SensorFigureEstimator::update(const ScanHistory& history, std::span<const KnownTarget> targets) {
  miss_.fade(fading());
  misses_.fade(fading());
  tail_.fade(fading());
  false_alarm_.fade(fading());
  for (double* value : {&squares_, &returns_}) *value *= fading();
  utime_ = history.newest().utime;
  num_beams_ = history.newest().num_beams;
  claims_.clear(history, 1);
  for (const auto& target : targets) claims_.claim(history, target.samples, target.existence);
  learn_clutter(history);
  if (const std::optional<int> age = settled_age(history))
    for (std::size_t k = 0; k < targets.size(); ++k)
      if (targets[k].existence >= params_.sure_existence && targets[k].held_scans >= *age)
        learn_target(history, *age, k, targets);
  choose();
}

// Of this sonar's newest scan that has settled; nothing where it was learnt from already.
std::optional<int> SensorFigureEstimator::settled_age(const ScanHistory& history) {
  int age = params_.settle_scans;
  while (age < history.size() && history.at_age(age).sensor != history.newest().sensor) ++age;
  const std::int64_t scan = history.pushed() - age;
  if (age >= history.size() || scan <= learnt_) return std::nullopt;
  learnt_ = scan;
  return age;
}

// False alarms: in beams that no target owns; of a sensor without beams, returns that none owns.
void SensorFigureEstimator::learn_clutter(const ScanHistory& history) {
  const ScanTable& newest = history.newest();
  const auto capacity = static_cast<std::size_t>(history.capacity());
  clutter_.resize(capacity);
  const auto of_age = [&](int age) -> Clutter& {
    return clutter_[static_cast<std::size_t>(history.pushed() - 1 - age) % capacity];
  };
  const BeamMask* mask = claims_.at_age(0);
  Clutter& latest = of_age(0);
  latest.free.assign(newest.background.size(), 1.0F);
  latest.share = {};
  if (mask != nullptr)
    for (std::size_t k = 0; k < latest.free.size(); ++k) latest.free[k] = 1.0F - mask->share[k];
  double faded = 1.0;
  for (int age = 0; age < history.size(); ++age, faded *= fading()) {
    if (history.at_age(age).sensor != newest.sensor) continue;
    Clutter& clutter = of_age(age);
    const Share before = clutter.share;
    take_clutter(history.at_age(age), clutter);
    false_alarm_.hits += faded * (clutter.share.hits - before.hits);
    false_alarm_.trials += faded * (clutter.share.trials - before.trials);
  }
}

void SensorFigureEstimator::take_clutter(const ScanTable& scan, Clutter& clutter) const {
  Share& share = clutter.share = {};
  if (scan.clutter == ClutterModel::point) {
    share.trials = static_cast<double>(scan.listened);
    for (std::size_t j = 0; j < scan.detections.size(); ++j)
      share.hits += static_cast<double>(scan.background[j] * clutter.free[j]);
    return;
  }
  for (int beam = 0; beam < scan.num_beams; ++beam) {
    const std::size_t slot = static_cast<std::size_t>(beam) + 1;
    // A return of what stands or is dense hides whether the background had one.
    const auto background =
        static_cast<double>(clutter.free[slot] * (scan.silent(beam) ? scan.listened : scan.background[slot]));
    share.trials += background;
    if (!scan.silent(beam)) share.hits += background;
  }
}

// Called once for each scan and target, `settle_scans` or more later, when it is known where the target was.
void SensorFigureEstimator::learn_target(const ScanHistory& history, int age, std::size_t index,
                                         std::span<const KnownTarget> targets) {
  const ScanTable& scan = history.at_age(age);
  const double seconds = history.seconds_at_age(age);
  const auto& samples = targets[index].samples;
  const Eigen::Vector2d sonar(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  const auto line_of_sight = [&](const KnownTarget& target) -> Eigen::Vector2d {
    const Eigen::Vector4d& state = target.samples[target.samples.size() / 2];
    return state.head<2>() + seconds * state.tail<2>() - sonar;
  };
  const Eigen::Vector2d own = line_of_sight(targets[index]);
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (k != index && targets[k].existence > kHidden && hides(scan, line_of_sight(targets[k]), own)) return;
  learn_return(scan, samples, seconds);
}

void SensorFigureEstimator::learn_return(const ScanTable& scan, std::span<const Eigen::Vector4d> samples,
                                         double seconds) {
  const double weight = 1.0 / static_cast<double>(samples.size());
  double reported = 0.0, silence = 0.0, lost = 0.0;
  double narrow = 0.0, residual = 0.0, range = 0.0, range_squares = 0.0;
  for (const auto& sample : samples) {
    const Sighting sighting = sight(scan, sample, seconds, {figures_.miss_probability, tail_.mean()});
    reported += weight * sighting.reported;
    silence += weight * sighting.silence;
    lost += weight * sighting.lost;
    tail_.hits += weight * sighting.wide;
    tail_.trials += weight * sighting.either;
    misses_.add(square(sighting.range / scan.max_range), weight * sighting.silence,
                weight * (sighting.silence + sighting.reported + sighting.lost));
    const double own = weight * sighting.reported * sighting.narrow;
    narrow += own;
    residual += own * sighting.residual;
    range += own * sighting.range;
    range_squares += own * sighting.range * sighting.range;
  }
  miss_.hits += silence;
  miss_.trials += silence + reported + lost;
  if (narrow < 0.5) return;
  // The return has drawn the trajectories towards it, so that its distance from their mean is too small on
  // average; the variance of the trajectories makes up for that.
  const double mean = residual / narrow;
  const double spread = range_squares / narrow - (range / narrow) * (range / narrow);
  squares_ += narrow * (mean * mean + spread);
  returns_ += narrow;
}

void SensorFigureEstimator::RangeMisses::add(double x, double hits, double trials) {
  n += trials;
  sum += trials * x;
  squares += trials * x * x;
  misses += hits;
  products += hits * x;
}

void SensorFigureEstimator::RangeMisses::fade(double factor) {
  for (double* value : {&n, &sum, &squares, &misses, &products}) *value *= factor;
}

// Weighted least squares of misses over x.
std::optional<SensorFigureEstimator::RangeMisses::Line> SensorFigureEstimator::RangeMisses::line(
    double doubt_sigmas) const {
  const double determinant = n * squares - sum * sum;
  if (n < kFewTrials || determinant <= 0.0) return std::nullopt;
  const double slope = (n * products - sum * misses) / determinant;
  const double mean = misses / n;
  if (slope < doubt_sigmas * std::sqrt(mean * (1.0 - mean) * n / determinant)) return std::nullopt;
  const double start = std::clamp((misses - slope * sum) / n, kLeastMiss, kMostMiss);
  return Line{start, std::min(slope, kMostMiss - start)};
}

// A given figure is used until the scans contradict it.
void SensorFigureEstimator::choose() {
  const core::SensorEstimate now = estimate();
  const auto doubted = [this](double given, double mean, double sigma) {
    return std::abs(given - mean) > params_.doubt_sigmas * sigma;
  };
  core::SonarParams use = given_;
  doubts_miss_ = given_.miss_probability &&
                 doubted(*given_.miss_probability, now.miss_probability, now.miss_probability_sigma);
  doubts_false_ =
      given_.false_alarm_probability && doubted(*given_.false_alarm_probability, now.false_alarm_probability,
                                                now.false_alarm_probability_sigma);
  doubts_sigma_ = doubted(given_.range_sigma, now.range_sigma, now.range_sigma_sigma);
  // Whether P_F is wrong shows in a scan or two, whether P_M is only after targets were tracked. Until then a
  // P_M that was given along with a wrong P_F is not believed either.
  if (!given_.miss_probability || doubts_miss_ || doubts_false_) use.miss_probability = now.miss_probability;
  if (!given_.false_alarm_probability || doubts_false_)
    use.false_alarm_probability = now.false_alarm_probability;
  if (doubts_sigma_) use.range_sigma = now.range_sigma;
  figures_ = figures_of(use);
  if (given_.point_sensor()) return;
  if (tail_.mean() - kSureSigmas * tail_.sigma() > kFewTails) figures_.tail_share = tail_.mean();
  const bool learns_miss = !given_.miss_probability || doubts_miss_ || doubts_false_;
  if (const auto line = learns_miss ? misses_.line(kSureSigmas) : std::nullopt) {
    figures_.miss_probability = line->start;
    figures_.range_loss = line->slope;
  }
}

core::SensorEstimate SensorFigureEstimator::estimate() const {
  core::SensorEstimate estimate;
  estimate.utime = utime_;
  estimate.miss_probability = miss_.mean();
  estimate.miss_probability_sigma = miss_.sigma();
  if (given_.point_sensor()) {
    const double scans = std::max(false_alarm_.trials, 1.0);
    estimate.false_alarm_probability =
        false_alarm_.trials > 0.0 ? false_alarm_.mean() / num_beams_ : params_.unknown_false_alarm;
    estimate.false_alarm_probability_sigma = std::sqrt(false_alarm_.hits + 1.0) / scans / num_beams_;
  } else {
    estimate.false_alarm_probability = false_alarm_.mean();
    estimate.false_alarm_probability_sigma = false_alarm_.sigma();
  }
  estimate.range_sigma = std::sqrt(squares_ / returns_);
  estimate.range_sigma_sigma = estimate.range_sigma / std::sqrt(2.0 * returns_);
  return estimate;
}

}  // namespace lookout::csht
