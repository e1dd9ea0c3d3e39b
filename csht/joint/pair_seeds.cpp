#include "csht/joint/pair_seeds.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "csht/joint/evidence/memory_span.hpp"
#include "csht/joint/evidence/scan_information.hpp"

namespace lookout::csht {
namespace {

constexpr double kMembershipGate = 16.0;  // Squared distance in sigmas beyond which no detection is a member.
constexpr double kWeakPosition = 1e4;     // Variance of the prior on position [m^2]: keeps the fit solvable.
constexpr std::size_t kReserve = 8192;    // Pairs for which memory is kept from the start.

// What a search may cost, whatever comes: bounds of ours, twice what a sea with everything at once asks for
// (sea_all.yaml, seed 3).
constexpr std::size_t kMostTried = 2'000'000;  // Pairs that are looked at,
constexpr std::size_t kMostPairs = 32'768;     // kept,
constexpr std::size_t kMostScores = 450'000;   // and scored, times scans; of points, times so many of them.
constexpr std::size_t kPointsPerScore = 32;

std::size_t ceil_div(std::size_t a, std::size_t b) {
  return (a + b - 1) / b;
}

// Of what a beam heard: of uneven beams in proportion to its width.
double bearing_sigma_at(const ScanTable& scan, int beam, const SensorFigures& figures) {
  if (!scan.uneven()) return figures.bearing_sigma;
  return figures.bearing_sigma * scan.fan->width(beam) / scan.fan->mean_step();
}

// A return that may be a target's.
struct NearReturn {
  int claim_index = 0;                // Beam, or index of the detection.
  double range = 0.0, azimuth = 0.0;  // [m], [rad].
  double membership = 0.0;            // Probability that it is, against clutter.
  double background = 1.0;            // See ScanTable,
  double worth = 1.0;                 // and likewise.
  double bearing_sigma = 0.0;         // Of the return [rad].
};

// Where a target is seen from a scan.
struct SeenAt {
  double range = 0.0, azimuth = 0.0;  // [m], [rad].
};

template <class Use>
void take_near(const ScanTable& scan, const SensorFigures& figures, const SeenAt& target, NearReturn one,
               Use use) {
  const double dr = (one.range - target.range) / figures.range_sigma;
  const double db = core::wrap_to_pi(one.azimuth - target.azimuth) / one.bearing_sigma;
  const double square = dr * dr + db * db;
  if (square > kMembershipGate) return;
  const double own = static_cast<double>(scan.gain) * one.worth * std::exp(-0.5 * square);
  one.membership = own / (1.0 + own);
  use(one);
}

// Calls `use` for each return of a scan that is near a target.
template <class Use>
void for_each_near(const ScanTable& scan, const SensorFigures& figures, const SeenAt& target, Use use) {
  if (scan.clutter == ClutterModel::point) {
    for (std::size_t i = 0; i < scan.detections.size(); ++i)
      take_near(scan, figures, target,
                {static_cast<int>(i), scan.detections[i].range, scan.detections[i].azimuth, 0.0,
                 static_cast<double>(scan.background[i]), static_cast<double>(scan.worth[i]),
                 figures.bearing_sigma},
                use);
    return;
  }
  const double middle = 0.5 * (scan.num_beams - 1);
  const int beam = static_cast<int>(
      std::lround(scan.beams_from_middle(core::wrap_to_pi(target.azimuth - scan.axis)) + middle));
  const int reach = 1 + scan.blur_reach;
  for (int b = std::max(0, beam - reach); b <= std::min(scan.num_beams - 1, beam + reach); ++b) {
    const std::size_t slot = static_cast<std::size_t>(b) + 1;
    if (scan.range[slot] > 0.0F)
      take_near(scan, figures, target,
                {b, static_cast<double>(scan.range[slot]), scan.axis + scan.bearing_of_beams(b - middle), 0.0,
                 static_cast<double>(scan.background[slot]), static_cast<double>(scan.worth[slot]),
                 bearing_sigma_at(scan, b, figures)},
                use);
  }
}

}  // namespace

void LineFit::add(const Eigen::Vector2d& position, double seconds, double azimuth, double range_variance,
                  double cross_variance, double membership) {
  const Eigen::Vector2d along(std::cos(azimuth), std::sin(azimuth));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Matrix2d inverse = membership * (along * along.transpose() / range_variance +
                                                across * across.transpose() / cross_variance);
  information.topLeftCorner<2, 2>() += inverse;
  information.topRightCorner<2, 2>() += seconds * inverse;
  information.bottomLeftCorner<2, 2>() += seconds * inverse;
  information.bottomRightCorner<2, 2>() += seconds * seconds * inverse;
  const Eigen::Vector2d pull = inverse * position;
  weighted.head<2>() += pull;
  weighted.tail<2>() += seconds * pull;
}

int birth_window(const ScanHistory& scans, const BirthParams& params, double background) {
  const double nats = std::max(nats_per_scan(scans.figures(), scans.newest(), background), params.least_nats);
  const double enough = std::ceil(params.enough_nats / nats);
  return static_cast<int>(std::min<double>(enough, oldest_within(params.window_s, scans)));
}

double background_along(const Eigen::Vector4d& trajectory, const ScanHistory& scans, int oldest) {
  double sum = 0.0, members = 0.0;
  for (int age = 0; age <= oldest; ++age) {
    const ScanTable& scan = scans.at_age(age);
    const Eigen::Vector2d at = trajectory.head<2>() + scans.seconds_at_age(age) * trajectory.tail<2>() -
                               Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
    for_each_near(scan, scans.figures(), {at.norm(), std::atan2(at.y(), at.x())}, [&](const NearReturn& one) {
      members += one.membership;
      sum += one.membership * one.background;
    });
  }
  return members > 0.0 ? sum / members : 1.0;
}

PairSeeds::PairSeeds(const BirthParams& params) : params_(params) {
  pairs_.resize(kReserve);
  pairs_.resize(0);
  scores_.reserve(kReserve);
  sum_.reserve(kReserve);
  step_.reserve(kReserve);
}

std::span<const BirthSeed> PairSeeds::propose(ScanLikelihood& likelihood, const TargetPrior& prior,
                                              const std::function<bool()>& stopped) {
  seeds_.clear();
  prior_ = prior;
  scans_ = &likelihood.scans();
  stopped_ = &stopped;
  collect_free_detections(likelihood);
  const int window = longest_window();
  const int first_look = std::min(window, oldest_within(params_.first_look_s, *scans_));
  pair_detections(first_look);
  if (scores_.empty()) return seeds_;
  score(likelihood, first_look);
  if (window > first_look) {
    keep_best(static_cast<std::size_t>(params_.first_look_keep));
    score(likelihood, window);
  }
  refine_and_merge(likelihood);
  weigh(likelihood);
  if (stopped()) return {};
  return seeds_;
}

// Where false returns are dense, a scan says less, and a target is weighed over more of them.
int PairSeeds::longest_window() const {
  const ScanTable& newest = scans_->newest();
  const float densest = *std::min_element(newest.background.begin(), newest.background.end());
  return birth_window(*scans_, params_, static_cast<double>(densest));
}

void PairSeeds::collect_free_detections(const ScanLikelihood& likelihood) {
  newest_.clear();
  older_.clear();
  for (int age = 0; age < scans_->size(); ++age) {
    if (-scans_->seconds_at_age(age) > params_.max_lag_s) break;
    if (age > 0 && age < params_.min_lag_scans) continue;
    const auto& detections = scans_->at_age(age).detections;
    for (std::size_t i = 0; i < detections.size(); ++i) {
      if (explained(likelihood, age, i)) continue;
      (age == 0 ? newest_ : older_).push_back({detections[i].p_earth, age});
    }
  }
}

bool PairSeeds::explained(const ScanLikelihood& likelihood, int age, std::size_t index) const {
  const ScanTable& scan = scans_->at_age(age);
  const bool point = scan.clutter == ClutterModel::point;
  const core::Detection& detection = scan.detections[index];
  return likelihood.explained(age, point ? static_cast<int>(index) : detection.beam, detection.range) >=
         params_.explained;
}

// Most pairs that are scored back to age `first_look`.
std::size_t PairSeeds::most_pairs(int first_look) const {
  const ScanTable& newest = scans_->newest();
  const std::size_t points = newest.clutter == ClutterModel::point ? newest.detections.size() : 0;
  const std::size_t cost = (static_cast<std::size_t>(first_look) + 1) *
                           std::max<std::size_t>(1, ceil_div(points, kPointsPerScore));
  return std::clamp<std::size_t>(kMostScores / cost, 1, kMostPairs);
}

// Calls `use` for each pair that a target may have made; of too many older detections every so many-th stands
// for all.
template <class Use>
void PairSeeds::for_each_pair(const Use& use) const {
  const double sigma = scans_->figures().range_sigma;
  const std::size_t stride = std::max<std::size_t>(1, ceil_div(older_.size() * newest_.size(), kMostTried));
  for (std::size_t k = 0; k < older_.size(); k += stride) {
    const SeedPoint& older = older_[k];
    const double seconds = -scans_->seconds_at_age(older.age);
    const double reach = prior_.max_speed() * seconds + 2.0 * std::numbers::sqrt2 * sigma;
    for (const SeedPoint& newest : newest_)
      if ((newest.position - older.position).squaredNorm() <= reach * reach) use(newest, older, seconds);
  }
}

// Of more pairs than can be scored every so many-th stands for all.
void PairSeeds::pair_detections(int first_look) {
  pairs_.resize(0);
  scores_.clear();
  std::size_t count = 0, next = 0;
  for_each_pair([&count](const SeedPoint&, const SeedPoint&, double) { ++count; });
  const std::size_t stride = std::max<std::size_t>(1, ceil_div(count, most_pairs(first_look)));
  for_each_pair([&](const SeedPoint& newest, const SeedPoint& older, double seconds) {
    if (next++ % stride == 0) add_pair(newest, older, seconds);
  });
  num_pairs_ = scores_.size();
  sum_.assign(scores_.size(), 0.0);
  scored_to_ = -1;
}

// The most probable trajectory given both detections: where they are close in time they say little of the
// velocity, which the normal prior then shrinks.
void PairSeeds::add_pair(const SeedPoint& newest, const SeedPoint& older, double seconds) {
  const double sigma = scans_->figures().range_sigma;
  const double prior_variance = prior_.velocity_sigma() * prior_.velocity_sigma();
  const double shrink = prior_variance / (prior_variance + 2.0 * sigma * sigma / (seconds * seconds));
  const Eigen::Vector2d velocity = shrink / seconds * (newest.position - older.position);
  const Eigen::Vector2d position = 0.5 * (newest.position + older.position + seconds * velocity);
  pairs_.north.push_back(position.x());
  pairs_.east.push_back(position.y());
  pairs_.north_velocity.push_back(velocity.x());
  pairs_.east_velocity.push_back(velocity.y());
  scores_.push_back({-std::numeric_limits<double>::infinity(), 0});
}

// Adds the evidence of older scans to the sums of all pairs, from where the last call ended to age `oldest`.
void PairSeeds::score(ScanLikelihood& likelihood, int oldest) {
  step_.resize(scores_.size());
  for (int age = scored_to_ + 1; age <= oldest; ++age) {
    if ((*stopped_)()) return;
    std::fill(step_.begin(), step_.end(), 0.0);
    add_log_ratio(scans_->at_age(age), likelihood.mask(age, ScanLikelihood::kNobody, -1), pairs_.span(),
                  scans_->seconds_at_age(age), params_.seed_tolerance, step_);
    for (std::size_t i = 0; i < scores_.size(); ++i) {
      sum_[i] += step_[i];
      if (sum_[i] > scores_[i].best) scores_[i] = {sum_[i], age};
    }
  }
  scored_to_ = oldest;
}

void PairSeeds::keep_best(std::size_t count) {
  order_.resize(scores_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (order_.size() > count) {
    std::nth_element(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(count), order_.end(),
                     [this](std::size_t a, std::size_t b) { return scores_[a].best > scores_[b].best; });
    order_.resize(count);
    std::sort(order_.begin(), order_.end());
  }
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const std::size_t i = order_[k];
    pairs_.north[k] = pairs_.north[i];
    pairs_.east[k] = pairs_.east[i];
    pairs_.north_velocity[k] = pairs_.north_velocity[i];
    pairs_.east_velocity[k] = pairs_.east_velocity[i];
    scores_[k] = scores_[i];
    sum_[k] = sum_[i];
  }
  pairs_.resize(order_.size());
  scores_.resize(order_.size());
  sum_.resize(order_.size());
}

void PairSeeds::refine_and_merge(const ScanLikelihood& likelihood) {
  order_.resize(scores_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(),
            [this](std::size_t a, std::size_t b) { return scores_[a].best > scores_[b].best; });
  int tried = 0;
  for (const std::size_t i : order_) {
    if ((*stopped_)()) return;
    if (static_cast<int>(seeds_.size()) >= params_.seeds || tried >= params_.tries_per_seed * params_.seeds)
      break;
    BirthSeed seed;
    ++tried;
    if (refine(likelihood, i, seed) && !merged(seed)) seeds_.push_back(seed);
  }
}

bool PairSeeds::merged(const BirthSeed& seed) {
  for (const BirthSeed& other : seeds_) {
    const Eigen::Vector4d offset = seed.guess.mean.head<4>() - other.guess.mean.head<4>();
    const Eigen::Matrix4d covariance =
        other.guess.covariance.topLeftCorner<4, 4>() + seed.guess.covariance.topLeftCorner<4, 4>();
    if (offset.dot(covariance.llt().solve(offset)) < params_.same_target) return true;
  }
  return false;
}

// Least squares over the detections of the window, each weighted with its membership: the share of its
// likelihood that the trajectory explains; clutter has the rest. One class of fuzzy c-means, [Yan2018] Eq.
// (22) and (23), with the noise class of [Dave1991].
bool PairSeeds::refine(const ScanLikelihood& likelihood, std::size_t index, BirthSeed& seed) const {
  Eigen::Vector4d state(pairs_.north[index], pairs_.east[index], pairs_.north_velocity[index],
                        pairs_.east_velocity[index]);
  const double prior_variance = prior_.velocity_sigma() * prior_.velocity_sigma();
  Eigen::Matrix4d covariance;
  for (int round = 0; round < params_.refine_rounds; ++round) {
    LineFit fit;
    fit.information.bottomRightCorner<2, 2>() += Eigen::Matrix2d::Identity() / prior_variance;
    fit.information.topLeftCorner<2, 2>() += Eigen::Matrix2d::Identity() / kWeakPosition;
    fit.weighted.head<2>() += state.head<2>() / kWeakPosition;
    for (int age = 0; age <= scores_[index].oldest; ++age) add_members(likelihood, age, state, fit);
    const Eigen::LLT<Eigen::Matrix4d> solver(fit.information);
    if (solver.info() != Eigen::Success) return false;
    state = solver.solve(fit.weighted);
    covariance = solver.solve(Eigen::Matrix4d::Identity());
  }
  seed.guess.mean.head<4>() = state;
  seed.guess.covariance.topLeftCorner<4, 4>() = covariance;
  seed.start_age = scores_[index].oldest;
  seed.window = birth_window(*scans_, params_, background_along(state, *scans_, seed.start_age));
  seed.log_odds = 0.5 * std::log(covariance.determinant()) + 2.0 * std::log(2.0 * std::numbers::pi);
  return true;
}

// Begins the evidence of those seeds whose window begins at the scan of this age.
void PairSeeds::begin_lines(ScanLikelihood& likelihood, int age) {
  const auto begins = [age](const BirthSeed& seed) { return seed.window == age; };
  if (std::none_of(seeds_.begin(), seeds_.end(), begins)) return;
  begun_.resize(seeds_.size());
  likelihood.begin(lines_.span(), scans_->seconds_at_age(age), age, begun_);
  for (std::size_t k = 0; k < seeds_.size(); ++k)
    if (begins(seeds_[k])) line_[k] = begun_[k];
}

// Adds to the odds of the seeds the evidence of all scans for their refined trajectories, summed over the
// scans at which the target may have appeared. Sorts them, the most probable first.
void PairSeeds::weigh(ScanLikelihood& likelihood) {
  int oldest = 0;
  for (const BirthSeed& seed : seeds_) oldest = std::max(oldest, seed.window);
  lines_.resize(seeds_.size());
  for (std::size_t k = 0; k < seeds_.size(); ++k) {
    const Trajectory& mean = seeds_[k].guess.mean;
    lines_.north[k] = mean[0];
    lines_.east[k] = mean[1];
    lines_.north_velocity[k] = mean[2];
    lines_.east_velocity[k] = mean[3];
  }
  line_.assign(seeds_.size(), 0.0);
  for (int age = oldest; age >= 0; --age) {
    if ((*stopped_)()) return;
    begin_lines(likelihood, age);
    add_births(likelihood.log_birth(age), line_);
    add_log_ratio(scans_->at_age(age), likelihood.mask(age, ScanLikelihood::kNobody, -1), lines_.span(),
                  scans_->seconds_at_age(age), params_.line_tolerance, line_);
  }
  const double log_density = prior_.log_standing(scans_->newest());
  for (std::size_t k = 0; k < seeds_.size(); ++k)
    seeds_[k].log_odds +=
        line_[k] + log_density + prior_.log_speed(seeds_[k].guess.mean.segment<2>(2).norm());
  std::sort(seeds_.begin(), seeds_.end(),
            [](const BirthSeed& a, const BirthSeed& b) { return a.log_odds > b.log_odds; });
}

// Adds the detections of one scan that are near the trajectory to the fit.
void PairSeeds::add_members(const ScanLikelihood& likelihood, int age, const Eigen::Vector4d& state,
                            LineFit& fit) const {
  const ScanTable& scan = scans_->at_age(age);
  const SensorFigures& figures = scans_->figures();
  const double seconds = scans_->seconds_at_age(age);
  const Eigen::Vector2d sonar(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  const Eigen::Vector2d at = state.head<2>() + seconds * state.tail<2>() - sonar;
  for_each_near(scan, figures, {at.norm(), std::atan2(at.y(), at.x())}, [&](const NearReturn& one) {
    if (likelihood.explained(age, one.claim_index, one.range) >= params_.explained) return;
    const double cross = one.range * one.bearing_sigma;
    fit.add(sonar + core::from_polar(one.range, one.azimuth), seconds, one.azimuth,
            figures.range_sigma * figures.range_sigma, cross * cross, one.membership);
  });
}

}  // namespace lookout::csht
