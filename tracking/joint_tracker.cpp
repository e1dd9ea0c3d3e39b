#include "tracking/joint_tracker.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "csht/fast_math.hpp"

namespace lookout::tracking {
namespace {

constexpr double kLeastShare = 0.02;          // Of a beam that is worth a claim.
constexpr double kEchoSigmas = 4.0;           // An echo this near a trajectory may be its own.
constexpr double kInView = 0.5;               // Visible share below which a track counts as out of view.
constexpr double kLeastReported = 0.02;       // Probability from which a track is weighed for the report.
constexpr double kPublishedTentative = 0.05;  // Existence from which a tentative track is published.
constexpr double kSeedReach = 30.0;  // Seeds farther than this from a track are not compared with it [m].
constexpr double kSameTarget = 9.0;  // Squared Mahalanobis distance, 4 degrees of freedom.
constexpr double kBetterSeed = 2.0;  // Nats by which a seed must beat a tentative track to replace it.
constexpr double kEnoughEffective = 50.0;  // Trajectories that carry a cloud that is as good as it gets.
constexpr double kSettledLogOdds = 4.0;    // Existence above which a track's odds are only updated.
constexpr double kTrustedShare = 0.08;     // Effective share of a cloud whose evidence is trusted.
constexpr std::size_t kPastStride = 8;     // Of a cloud's trajectories, for its claims on past scans.
constexpr double kLeastNats = 0.05;        // Of information a scan.
constexpr double kBirthNats = 11.0;        // Evidence that a new target needs. csht_limits, idea 8.

int scans_in(double seconds, double period) {
  return static_cast<int>(std::ceil(seconds / period));
}

int capacity_of(const JointTrackerParams& params, const core::SonarParams& sonar) {
  return 1 + scans_in(std::max(params.cloud.memory_s, params.birth.window_s), sonar.scan_period);
}

csht::SensorModelParams model_of(const JointTrackerParams& params, const core::SonarParams& sonar) {
  csht::SensorModelParams model = params.sensor;
  model.clutter = csht::clutter_model_of(sonar);
  return model;
}

// Mean information of one scan on a target in view [nats]. csht_limits, idea 8.
double nats_per_scan(const csht::SensorFigures& f, const csht::ScanTable& scan) {
  if (scan.clutter == csht::ClutterModel::point)
    return (1.0 - f.miss_probability) * std::log(static_cast<double>(scan.gain));
  const double detect = 1.0 - f.miss_probability;
  return detect * (std::log(static_cast<double>(scan.gain)) - 0.5) +
         f.miss_probability * std::log(f.miss_probability / (1.0 - f.false_alarm_probability));
}

// Squared Mahalanobis distance of position and velocity, with both covariances.
double state_distance(const CloudMoments& a, const CloudMoments& b) {
  const Eigen::Vector4d offset = a.mean.head<4>() - b.mean.head<4>();
  const Eigen::Matrix4d covariance = a.covariance.topLeftCorner<4, 4>() + b.covariance.topLeftCorner<4, 4>();
  return offset.dot(covariance.llt().solve(offset));
}

}  // namespace

double probability(double log_odds) {
  return 1.0 / (1.0 + std::exp(-log_odds));
}
double JointTrack::existence() const {
  return probability(log_odds);
}

JointTracker::JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar,
                           std::uint64_t seed)
    : params_(params),
      sonar_(sonar),
      seed_(seed),
      random_(seed, core::RandomStream::tracker),
      likelihood_(csht::figures_of(sonar), model_of(params, sonar), params.tolerance,
                  capacity_of(params, sonar), params.life.max_tracks),
      birth_(params.birth, sonar.max_speed),
      sampler_(params.cloud, sonar.max_speed, random_),
      report_(params.report, random_),
      unseen_(params.birth.expected_targets) {
  validate(params);
  tracks_.reserve(static_cast<std::size_t>(params.life.max_tracks));
}

std::span<const core::Track> JointTracker::update(const core::PosedScan& scan) {
  random_.reseed(seed_, core::RandomStream::tracker, static_cast<std::uint64_t>(scan.scan.sequence));
  take(scan);
  claim_provisionally();
  update_tracks();
  end_twins();
  begin_tracks();
  end_lives();
  choose_report();
  publish();
  return published_;
}

void JointTracker::take(const core::PosedScan& scan) {
  likelihood_.push(scan);
  if (likelihood_.scans().size() < 2) return;
  const double seconds = -likelihood_.scans().seconds_at_age(1);
  const double death = 1.0 - std::exp(-seconds / params_.life.mean_life_s);
  for (JointTrack& track : tracks_) {
    if (!track.used) continue;
    track.cloud.predict(seconds);
    track.moments = track.cloud.moments();
    const double alive = track.existence() * (1.0 - death);
    track.log_odds = std::log(alive / (1.0 - alive));
  }
}

// What each track would take of the scan on its own, so that the others know before they are updated.
void JointTracker::claim_provisionally() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    track.log_ratio.assign(track.cloud.size(), 0.0);
    likelihood_.add(track.cloud, track.moments.mean, {0, 0}, static_cast<int>(slot), track.log_ratio);
  }
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    likelihood_.set_existence(static_cast<int>(slot), track.existence());
    if (track.existence() < JointLikelihood::kLeastExistence) continue;
    std::swap(fresh_, track.cloud);
    track.cloud = fresh_;
    track.cloud.reweigh(track.log_ratio);
    observe(slot, 0, true, 1);
    std::swap(fresh_, track.cloud);
  }
}

void JointTracker::update_tracks() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot)
    if (tracks_[slot].used) update_track(slot);
}

void JointTracker::update_track(std::size_t slot) {
  JointTrack& track = tracks_[slot];
  const int self = static_cast<int>(slot);
  const int beam =
      std::max(0, beam_at(likelihood_.scans().newest(), track.moments.mean[0], track.moments.mean[1]));
  if (likelihood_.mask(0, self, beam) != nullptr) {
    track.log_ratio.assign(track.cloud.size(), 0.0);
    likelihood_.add(track.cloud, track.moments.mean, {0, 0}, self, track.log_ratio);
  }
  track.log_odds += track.cloud.reweigh(track.log_ratio);
  likelihood_.set_existence(self, track.existence());
  if (track.cloud.effective_size() < params_.cloud.refresh_share * static_cast<double>(track.cloud.size()))
    refresh(slot);
  track.moments = track.cloud.moments();
  likelihood_.forget_claims(self, 0);
  const bool claims = track.existence() >= JointLikelihood::kLeastExistence;
  observe(slot, 0, claims, 1);
  if (claims && !track.claims_filled) fill_past_claims(slot);
}

AgeSpan JointTracker::memory_of(const JointTrack& track) const {
  const csht::ScanHistory& scans = likelihood_.scans();
  const std::int64_t since_first = scans.pushed() - 1 - track.first_scan;
  int oldest = static_cast<int>(std::min<std::int64_t>(since_first, scans.size() - 1));
  while (oldest > 0 && -scans.seconds_at_age(oldest) > params_.cloud.memory_s) --oldest;
  return {0, oldest};
}

// Draws the cloud afresh from the likelihood of the scans it remembers.
void JointTracker::refresh(std::size_t slot) {
  JointTrack& track = tracks_[slot];
  SamplingTask task;
  task.guess = track.cloud.moments();
  // A cloud that one scan has cut down to a few trajectories says little of its own spread.
  const double rest = std::min(1.0, track.cloud.dimensions() / track.cloud.effective_size());
  task.guess.covariance += rest * track.moments.covariance;
  task.ages = memory_of(track);
  task.self = static_cast<int>(slot);
  task.samples = params_.cloud.trajectories;
  task.rounds = params_.cloud.refresh_rounds;
  task.curved = track.cloud.curved;
  const SamplingResult result = sampler_.sample(task, likelihood_, random_, fresh_);
  const double effective = result.effective_share * static_cast<double>(task.samples);
  if (effective <= std::min(track.cloud.effective_size(), kEnoughEffective)) return;
  std::swap(track.cloud, fresh_);
  track.claims_filled = false;
  // Odds that were picked as the best of many are too high; drawn again they are not. csht_limits, idea 3.
  const bool whole_life = task.ages.oldest == likelihood_.scans().pushed() - 1 - track.first_scan;
  if (whole_life && track.log_odds < kSettledLogOdds && result.effective_share > kTrustedShare)
    track.log_odds = std::min(result.log_evidence + track.log_density, kSettledLogOdds);
}

// Notes in which beams the track is, whether it is in view and whether an echo may be its own.
void JointTracker::observe(std::size_t slot, int age, bool claim, std::size_t stride) {
  JointTrack& track = tracks_[slot];
  const csht::ScanTable& scan = likelihood_.scans().at_age(age);
  const double seconds = likelihood_.scans().seconds_at_age(age);
  const double gate = kEchoSigmas / static_cast<double>(scan.inverse_sigma);
  beam_share_.resize(static_cast<std::size_t>(scan.num_beams), 0.0);
  beam_range_.resize(static_cast<std::size_t>(scan.num_beams), 0.0);
  beams_touched_.clear();
  double visible = 0.0;
  double echo = 0.0;
  double total = 0.0;
  const JointCloud& cloud = track.cloud;
  const double half_square = 0.5 * seconds * seconds;
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    const double north =
        cloud.north[i] + seconds * cloud.north_velocity[i] + half_square * cloud.north_acceleration[i];
    const double east =
        cloud.east[i] + seconds * cloud.east_velocity[i] + half_square * cloud.east_acceleration[i];
    total += cloud.weight[i];
    const int beam = beam_at(scan, north, east);
    const double range = std::hypot(north - scan.T_earth_sonar.north, east - scan.T_earth_sonar.east);
    if (beam < 0 || beam >= scan.num_beams || range > scan.max_range) continue;
    const auto b = static_cast<std::size_t>(beam);
    visible += cloud.weight[i];
    if (beam_share_[b] == 0.0) beams_touched_.push_back(beam);
    beam_share_[b] += cloud.weight[i];
    beam_range_[b] += cloud.weight[i] * range;
    const auto heard = static_cast<double>(scan.range[b + 1]);
    if (std::abs(heard - range) < gate) echo += cloud.weight[i];
  }
  if (age == 0) {
    track.visible_share = visible / total;
    track.echo_share = echo / total;
  }
  for (const int beam : beams_touched_) {
    const auto b = static_cast<std::size_t>(beam);
    if (claim && beam_share_[b] > kLeastShare * total && scan.clutter != csht::ClutterModel::point)
      likelihood_.add_claim(
          age, {static_cast<int>(slot), beam, static_cast<float>(beam_range_[b] / beam_share_[b]),
                static_cast<float>(beam_share_[b] / total)});
    beam_share_[b] = 0.0;
    beam_range_[b] = 0.0;
  }
  if (scan.clutter == csht::ClutterModel::point && claim) observe_point(slot, age);
}

// For a sensor without beams: how probably each detection is the track's.
void JointTracker::observe_point(std::size_t slot, int age) {
  JointTrack& track = tracks_[slot];
  const csht::ScanTable& scan = likelihood_.scans().at_age(age);
  const double seconds = likelihood_.scans().seconds_at_age(age);
  const csht::SensorFigures& figures = likelihood_.scans().figures();
  const auto count = scan.detections.size();
  beam_share_.assign(std::max(count, beam_share_.size()), 0.0);
  double echo = 0.0;
  for (std::size_t i = 0; i < track.cloud.size(); ++i) {
    if (track.cloud.weight[i] < 1e-4) continue;
    const double north =
        track.cloud.north[i] + seconds * track.cloud.north_velocity[i] - scan.T_earth_sonar.north;
    const double east =
        track.cloud.east[i] + seconds * track.cloud.east_velocity[i] - scan.T_earth_sonar.east;
    const double range = std::hypot(north, east);
    const double azimuth = std::atan2(east, north);
    double sum = figures.miss_probability;
    detection_ratio_.assign(count, 0.0);
    for (std::size_t j = 0; j < count; ++j) {
      const double dr = (scan.detections[j].range - range) / figures.range_sigma;
      const double db = core::wrap_to_pi(scan.detections[j].azimuth - azimuth) / figures.bearing_sigma;
      sum += detection_ratio_[j] = static_cast<double>(scan.gain) * std::exp(-0.5 * (dr * dr + db * db));
    }
    for (std::size_t j = 0; j < count; ++j)
      beam_share_[j] += track.cloud.weight[i] * detection_ratio_[j] / sum;
  }
  for (std::size_t j = 0; j < count; ++j) {
    echo += beam_share_[j];
    if (beam_share_[j] > kLeastShare)
      likelihood_.add_claim(
          age, {static_cast<int>(slot), static_cast<int>(j), static_cast<float>(scan.detections[j].range),
                static_cast<float>(beam_share_[j])});
    beam_share_[j] = 0.0;
  }
  if (age == 0) track.echo_share = echo;
}

void JointTracker::fill_past_claims(std::size_t slot) {
  JointTrack& track = tracks_[slot];
  if (track.has_claims) likelihood_.forget_past_claims(static_cast<int>(slot));
  track.claims_filled = track.has_claims = true;
  for (int age = 1; age <= memory_of(track).oldest; ++age) observe(slot, age, true, kPastStride);
}

// Of two tracks that are on one target the less probable ends.
void JointTracker::end_twins() {
  for (std::size_t a = 0; a < tracks_.size(); ++a) {
    for (std::size_t b = 0; b < a && tracks_[a].used; ++b) {
      if (!tracks_[b].used) continue;
      const auto offset = (tracks_[a].moments.mean - tracks_[b].moments.mean).eval();
      if (offset.head<2>().norm() > params_.life.twin_distance) continue;
      if (offset.segment<2>(2).norm() > params_.life.twin_speed) continue;
      const bool a_goes = tracks_[a].confirmed_once == tracks_[b].confirmed_once
                              ? tracks_[a].log_odds < tracks_[b].log_odds
                              : tracks_[b].confirmed_once;
      end(a_goes ? a : b);
    }
  }
}

void JointTracker::begin_tracks() {
  for (const BirthSeed& seed : birth_.propose(likelihood_))
    if (seed.log_odds > params_.life.tentative_log_odds - params_.birth.hopeless && !known(seed))
      begin_track(seed);
}

// Whether a track stands for the seed already. A tentative one that is much less probable gives way.
bool JointTracker::known(const BirthSeed& seed) {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    const JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    if ((track.moments.mean.head<2>() - seed.guess.mean.head<2>()).norm() > kSeedReach) continue;
    if (state_distance(track.moments, seed.guess) > kSameTarget) continue;
    if (track.confirmed_once || seed.log_odds < track.log_odds + kBetterSeed) return true;
    end(slot);
  }
  return false;
}

bool JointTracker::begin_track(const BirthSeed& seed) {
  SamplingTask task;
  task.guess = seed.guess;
  task.ages = seed.ages;
  task.samples = params_.birth.samples;
  task.rounds = params_.birth.rounds;
  task.give_up_below = params_.life.tentative_log_odds - params_.birth.hopeless - seed.log_density;
  if (sampler_.sample(task, likelihood_, random_, fresh_).log_evidence < task.give_up_below) return false;
  // Of many seeds the luckiest estimates stand out: once more, with trajectories that nothing was chosen by.
  task.guess = fresh_.moments();
  task.samples = params_.cloud.trajectories;
  const SamplingResult result = sampler_.sample(task, likelihood_, random_, fresh_);
  const double log_odds = result.log_evidence + seed.log_density;
  if (log_odds < params_.life.tentative_log_odds || result.effective_share < kTrustedShare) return false;
  const std::size_t slot = free_slot();
  if (slot >= static_cast<std::size_t>(params_.life.max_tracks)) return false;
  const csht::ScanHistory& scans = likelihood_.scans();
  JointTrack& track = tracks_[slot];
  track.used = true;
  track.id = ++last_id_;
  std::swap(track.cloud, fresh_);
  track.moments = track.cloud.moments();
  track.log_odds = std::min(log_odds, kSettledLogOdds);
  track.log_density = seed.log_density;
  track.first_scan = scans.pushed() - 1 - seed.ages.oldest;
  track.first_utime = scans.at_age(seed.ages.oldest).utime;
  track.last_detection_utime = scans.newest().utime;
  track.out_of_view = track.reported = track.confirmed_once = track.claims_filled = track.has_claims = false;
  likelihood_.set_existence(static_cast<int>(slot), track.existence());
  const bool claims = track.existence() >= JointLikelihood::kLeastExistence;
  observe(slot, 0, claims, 1);
  if (claims) fill_past_claims(slot);
  return true;
}

std::size_t JointTracker::free_slot() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot)
    if (!tracks_[slot].used) return slot;
  if (tracks_.size() < tracks_.capacity())
    tracks_.emplace_back();
  else
    return tracks_.size();
  return tracks_.size() - 1;
}

void JointTracker::end_lives() {
  const std::int64_t now = likelihood_.scans().newest().utime;
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    if (track.echo_share > kInView) track.last_detection_utime = now;
    const bool out = track.visible_share < kInView;
    if (out && !track.out_of_view) track.out_of_view_utime = now;
    track.out_of_view = out;
    if (life_over(track)) end(slot);
  }
}

bool JointTracker::life_over(const JointTrack& track) const {
  if (track.log_odds < params_.life.tentative_log_odds) return true;
  if (track.confirmed_once && track.log_odds < params_.life.end_log_odds) return true;
  if (!track.out_of_view) return false;
  const double out = core::seconds(likelihood_.scans().newest().utime - track.out_of_view_utime);
  return !track.confirmed_once || out > params_.life.coast_s;
}

void JointTracker::end(std::size_t slot) {
  tracks_[slot].used = false;
  likelihood_.set_existence(static_cast<int>(slot), 0.0);
  likelihood_.forget_claims(static_cast<int>(slot));
}

// Mean number of targets in view that no track stands for: those of the prior, found at the rate at which
// evidence comes in, and those that enter. csht_limits, idea 8.
double JointTracker::unseen_targets() {
  const csht::ScanTable& scan = likelihood_.scans().newest();
  const double nats = std::max(kLeastNats, nats_per_scan(likelihood_.scans().figures(), scan));
  const double found = std::min(1.0, nats / kBirthNats);
  const double sector = std::min(2.0 * std::numbers::pi, scan.num_beams * scan.bearing_step);
  // Mean flux of a uniform flow over a border: speed x border / (pi area), here a sector's.
  const double border = scan.max_range * (sector + (scan.whole_circle ? 0.0 : 2.0));
  const double area = 0.5 * sector * scan.max_range * scan.max_range;
  const double mean_speed = 2.0 / 3.0 * sonar_.max_speed;
  const double entering =
      params_.birth.expected_targets * mean_speed * border / (std::numbers::pi * area) * sonar_.scan_period;
  unseen_ += entering + params_.birth.interior_rate - found * unseen_;
  double tentative = 0.0;
  for (const JointTrack& track : tracks_)
    if (track.used && track.log_odds < 0.0) tentative += track.existence() * track.visible_share;
  return std::max(0.0, unseen_ - tentative);
}

void JointTracker::choose_report() {
  candidates_.clear();
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    JointTrack& track = tracks_[slot];
    track.reported = false;
    const double p = track.used ? track.existence() * track.visible_share : 0.0;
    if (p < kLeastReported || track.out_of_view) continue;
    candidates_.push_back({slot, p, track.moments.covariance(0, 0) + track.moments.covariance(1, 1)});
  }
  const std::size_t count = report_.choose(candidates_, unseen_targets(), random_);
  for (std::size_t i = 0; i < count; ++i) {
    JointTrack& track = tracks_[candidates_[i].slot];
    track.reported = track.confirmed_once = true;
  }
}

void JointTracker::publish() {
  published_.clear();
  for (const JointTrack& track : tracks_) {
    if (!track.used) continue;
    const bool coasting = track.confirmed_once && track.out_of_view;
    if (!track.reported && !coasting && track.existence() < kPublishedTentative) continue;
    core::Track& out = published_.emplace_back();
    out.id = track.id;
    out.status = track.reported ? core::TrackStatus::confirmed
                 : coasting     ? core::TrackStatus::coasting
                                : core::TrackStatus::tentative;
    out.state = track.moments.mean.head<4>();
    out.covariance = track.moments.covariance.topLeftCorner<4, 4>();
    out.existence = track.existence();
    out.first_utime = track.first_utime;
    out.last_detection_utime = track.last_detection_utime;
  }
}

}  // namespace lookout::tracking
