#include "tracking/joint_tracker.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "tracking/joint_proposal.hpp"

namespace lookout::tracking {
namespace {

constexpr double kInView = 0.5;               // Visible share below which a track counts as out of view.
constexpr double kLeastReported = 0.02;       // Probability from which a track is weighed for the report.
constexpr double kPublishedTentative = 0.05;  // Existence from which a tentative track is published.
constexpr double kSeedReach = 30.0;  // Seeds farther than this from a track are not compared with it [m].
constexpr double kSameTarget = 9.0;  // Squared Mahalanobis distance, 4 degrees of freedom.
constexpr double kBetterSeed = 2.0;  // Nats by which a seed must beat a tentative track to replace it.
constexpr double kEnoughEffective = 50.0;   // Trajectories that carry a cloud that is as good as it gets.
constexpr double kSettledLogOdds = 4.0;     // Existence above which a track's odds are only updated.
constexpr double kFigureChange = 0.01;      // Relative change of a sensor figure that is worth a rewrite.
constexpr std::size_t kTargetSamples = 32;  // Trajectories that stand for a target in the sensor's figures.
constexpr double kTrustedShare = 0.08;      // Effective share of a cloud whose evidence is trusted.

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

// Squared Mahalanobis distance of position and velocity, with both covariances.
double state_distance(const CloudMoments& a, const CloudMoments& b) {
  const Eigen::Vector4d offset = a.mean.head<4>() - b.mean.head<4>();
  const Eigen::Matrix4d covariance = a.covariance.topLeftCorner<4, 4>() + b.covariance.topLeftCorner<4, 4>();
  return offset.dot(covariance.llt().solve(offset));
}

bool differ(double a, double b) {
  return std::abs(a - b) > kFigureChange * std::min(a, b);
}

bool differ(const csht::SensorFigures& a, const csht::SensorFigures& b) {
  return differ(a.miss_probability, b.miss_probability) ||
         differ(a.false_alarm_probability, b.false_alarm_probability) ||
         differ(a.clutter_per_scan, b.clutter_per_scan) || differ(a.range_sigma, b.range_sigma);
}

// Equally likely trajectories of a cloud, by systematic resampling.
void resample(const JointCloud& cloud, std::vector<Eigen::Vector4d>& samples) {
  samples.clear();
  const double step = 1.0 / static_cast<double>(kTargetSamples);
  double next = 0.5 * step;
  double sum = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (sum += cloud.weight[i]; next < sum && samples.size() < kTargetSamples; next += step)
      samples.emplace_back(cloud.north[i], cloud.east[i], cloud.north_velocity[i], cloud.east_velocity[i]);
}

const JointTrackerParams& validated(const JointTrackerParams& params) {
  validate(params);
  return params;
}

}  // namespace

JointTracker::JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar,
                           std::uint64_t seed, std::unique_ptr<BirthMethod> births)
    : params_(validated(params)),
      max_speed_(sonar.max_speed),
      seed_(seed),
      random_(seed, core::RandomStream::tracker),
      likelihood_(csht::figures_of(sonar), model_of(params, sonar), params.tolerance,
                  capacity_of(params, sonar), params.life.max_tracks),
      sampler_(params.cloud, sonar.max_speed, random_),
      manoeuvre_(params.manoeuvre, params.cloud.trajectories),
      birth_(params.birth, sonar.max_speed),
      births_(std::move(births)),
      unseen_(params.birth, sonar.max_speed),
      report_(params.report, random_),
      figures_({}, sonar) {
  likelihood_.set_figures(figures_.figures());
  tracks_.reserve(static_cast<std::size_t>(params.life.max_tracks));
}

std::span<const core::Track> JointTracker::update(const core::PosedScan& scan) {
  random_.reseed(seed_, core::RandomStream::tracker, static_cast<std::uint64_t>(scan.scan.sequence));
  take(scan);
  claim_provisionally();
  update_tracks();
  end_twins();
  if (births_ != nullptr)
    begin_on_proposals(scan);
  else
    begin_tracks();
  end_lives();
  choose_report();
  learn_sensor();
  publish();
  return published_;
}

std::span<const core::Track> JointTracker::retrodict(std::int64_t utime) {
  return retrodiction_.at(utime, tracks_, likelihood_.scans(), params_.report.min_existence);
}

void JointTracker::take(const core::PosedScan& scan) {
  likelihood_.push(scan);
  const csht::ScanHistory& scans = likelihood_.scans();
  const double seconds = scans.size() < 2 ? 0.0 : -scans.seconds_at_age(1);
  unseen_targets_ = unseen_.update(scans.newest(), scans.figures(), seconds);
  retrodiction_.forget_before(scans.at_age(scans.size() - 1).utime);
  const double survival = std::exp(-seconds / params_.life.mean_life_s);
  for (JointTrack& track : tracks_) {
    if (!track.used) continue;
    track.cloud.predict(seconds);
    track.moments = track.cloud.moments();
    track.log_odds = log_odds(track.existence() * survival);
  }
}

// What each track would take of the scan on its own, so that the others know
// before they are updated.
void JointTracker::claim_provisionally() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    const int self = static_cast<int>(slot);
    track.log_ratio.assign(track.cloud.size(), 0.0);
    likelihood_.add(track.cloud, track.moments.mean, {0, 0}, JointLikelihood::kEverybody, track.log_ratio);
    likelihood_.set_existence(self, track.existence());
    if (track.existence() < JointLikelihood::kLeastExistence) continue;
    fresh_ = track.cloud;
    fresh_.reweigh(track.log_ratio);
    observer_.claim(self, fresh_, likelihood_);
  }
}

void JointTracker::update_tracks() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    if (!tracks_[slot].used) continue;
    update_track(slot);
    judge_motion(slot);
    claim(slot);
  }
}

void JointTracker::update_track(std::size_t slot) {
  JointTrack& track = tracks_[slot];
  const int self = static_cast<int>(slot);
  const csht::ScanHistory& scans = likelihood_.scans();
  const int beam = std::max(0, beam_at(scans.newest(), track.moments.mean[0], track.moments.mean[1]));
  const bool shared = likelihood_.mask(0, self, beam) != nullptr;
  if (shared) {
    track.log_ratio.assign(track.cloud.size(), 0.0);
    likelihood_.add(track.cloud, track.moments.mean, {0, 0}, self, track.log_ratio);
  }
  const double evidence = track.cloud.reweigh(track.log_ratio);
  track.log_odds += evidence;
  track.highest_log_odds = std::max(track.highest_log_odds, track.log_odds);
  const bool tells = !shared && !track.out_of_view;
  track.recent.add(evidence, tells ? nats_per_scan(scans.figures(), scans.newest()) : evidence);
  const double enough = params_.cloud.refresh_share * static_cast<double>(track.cloud.size());
  if (track.cloud.curved || track.cloud.effective_size() < enough) refresh(slot);
  track.moments = track.cloud.moments();
}

void JointTracker::claim(std::size_t slot) {
  JointTrack& track = tracks_[slot];
  const int self = static_cast<int>(slot);
  likelihood_.set_existence(self, track.existence());
  likelihood_.forget_claims(self, 0);
  const bool claims = track.existence() >= JointLikelihood::kLeastExistence;
  observer_.observe(self, track, claims, likelihood_);
  if (!claims || track.claims_are_fresh) return;
  observer_.claim_past(self, track, memory_of(track).oldest, likelihood_);
  track.claims_are_fresh = true;
}

AgeSpan JointTracker::memory_of(const JointTrack& track) const {
  const csht::ScanHistory& scans = likelihood_.scans();
  if (track.cloud.curved) return {0, manoeuvre_.window(scans)};
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
  // A cloud that one scan has cut down to a few trajectories says little of its
  // own spread.
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
  track.claims_are_fresh = false;
  // Odds that were picked as the best of many are too high; drawn again they
  // are not. docs/tracker.md.
  const bool whole_life = track.remembers_birth && !track.cloud.curved &&
                          task.ages.oldest == likelihood_.scans().pushed() - 1 - track.first_scan;
  if (whole_life && track.log_odds < kSettledLogOdds && result.effective_share > kTrustedShare)
    track.log_odds = std::min(result.log_evidence + track.log_density, kSettledLogOdds);
}

void JointTracker::judge_motion(std::size_t slot) {
  JointTrack& track = tracks_[slot];
  if (track.highest_log_odds < params_.manoeuvre.least_log_odds || track.out_of_view) return;
  const auto judgement =
      manoeuvre_.judge(static_cast<int>(slot), track, likelihood_, sampler_, random_, fresh_);
  if (judgement.verdict == JointManoeuvre::Verdict::keep) return;
  const bool curve = judgement.verdict == JointManoeuvre::Verdict::curve;
  std::swap(track.cloud, fresh_);
  track.moments = track.cloud.moments();
  track.first_scan = likelihood_.scans().pushed() - 1 - judgement.oldest;
  track.remembers_birth = false;
  track.claims_are_fresh = false;
  // What the line lost by not bending was no evidence against the target.
  if (curve)
    track.log_odds = std::max(track.log_odds, std::min(track.log_odds + judgement.evidence, kSettledLogOdds));
  decide(track, curve ? DecisionKind::manoeuvre : DecisionKind::straighten, judgement.evidence,
         curve ? "a curve explains the latest scans better" : "a straight line explains them as well");
}

// Of two tracks that are on one target the less probable ends.
void JointTracker::end_twins() {
  for (std::size_t a = 0; a < tracks_.size(); ++a) {
    for (std::size_t b = 0; b < a && tracks_[a].used; ++b) {
      if (!tracks_[b].used) continue;
      const CloudMoments::Vector6 offset = tracks_[a].moments.mean - tracks_[b].moments.mean;
      if (offset.head<2>().norm() > params_.life.twin_distance) continue;
      if (offset.segment<2>(2).norm() > params_.life.twin_speed) continue;
      const bool a_goes = tracks_[a].confirmed_once == tracks_[b].confirmed_once
                              ? tracks_[a].log_odds < tracks_[b].log_odds
                              : tracks_[b].confirmed_once;
      end(a_goes ? a : b, DecisionKind::merge, "on the same target as a surer track");
    }
  }
}

void JointTracker::begin_tracks() {
  for (const BirthSeed& seed : birth_.propose(likelihood_))
    if (seed.log_odds > params_.life.tentative_log_odds - params_.birth.hopeless && !known(seed))
      begin_track(seed);
}

void JointTracker::begin_on_proposals(const core::PosedScan& scan) {
  living_.clear();
  for (const JointTrack& track : tracks_) {
    if (!track.used || track.existence() < JointLikelihood::kLeastExistence) continue;
    core::Track& living = living_.emplace_back();
    living.state = track.moments.mean.head<4>();
    living.covariance = track.moments.covariance.topLeftCorner<4, 4>();
  }
  const csht::ScanHistory& scans = likelihood_.scans();
  const BirthDensity density = birth_density(scans.newest(), max_speed_, params_.birth);
  for (const core::MotionElement& element : births_->propose(scan, living_)) {
    const BirthSeed seed = seed_of(element, scans, density);
    if (!known(seed)) begin_track(seed);
  }
}

// Whether a track stands for the seed already. A tentative one that is much less probable gives way.
bool JointTracker::known(const BirthSeed& seed) {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    const JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    if ((track.moments.mean.head<2>() - seed.guess.mean.head<2>()).norm() > kSeedReach) continue;
    if (state_distance(track.moments, seed.guess) > kSameTarget) continue;
    if (track.confirmed_once || seed.log_odds < track.log_odds + kBetterSeed) return true;
    end(slot, DecisionKind::merge, "a better candidate takes its place");
  }
  return false;
}

// Draws the density of a seed to `fresh_`. @return whether it is worth a track.
bool JointTracker::draw_birth(const BirthSeed& seed, double& log_odds) {
  SamplingTask task;
  task.guess = seed.guess;
  task.ages = seed.ages;
  task.samples = params_.birth.samples;
  task.rounds = params_.birth.rounds;
  task.give_up_below = params_.life.tentative_log_odds - params_.birth.hopeless - seed.log_density;
  if (sampler_.sample(task, likelihood_, random_, fresh_).log_evidence < task.give_up_below) return false;
  // Of many seeds the luckiest estimates stand out: once more, with
  // trajectories that nothing was chosen by.
  task.guess = fresh_.moments();
  task.samples = params_.cloud.trajectories;
  const SamplingResult result = sampler_.sample(task, likelihood_, random_, fresh_);
  log_odds = result.log_evidence + seed.log_density;
  return log_odds >= params_.life.tentative_log_odds && result.effective_share >= kTrustedShare;
}

void JointTracker::begin_track(const BirthSeed& seed) {
  double log_odds = 0.0;
  if (!draw_birth(seed, log_odds)) return;
  const std::size_t slot = free_slot();
  if (slot >= static_cast<std::size_t>(params_.life.max_tracks)) return;
  const csht::ScanHistory& scans = likelihood_.scans();
  JointTrack& track = tracks_[slot];
  track.used = true;
  track.id = ++last_id_;
  std::swap(track.cloud, fresh_);
  track.moments = track.cloud.moments();
  track.log_odds = track.highest_log_odds = std::min(log_odds, kSettledLogOdds);
  track.log_density = seed.log_density;
  track.recent.clear();
  track.first_scan = scans.pushed() - 1 - seed.ages.oldest;
  track.first_utime = scans.at_age(seed.ages.oldest).utime;
  track.last_detection_utime = scans.newest().utime;
  track.remembers_birth = true;
  track.out_of_view = track.reported = track.confirmed_once = false;
  track.has_claims = track.claims_are_fresh = false;
  claim(slot);
  decide(track, DecisionKind::begin, track.log_odds, "echoes that no track explains");
}

std::size_t JointTracker::free_slot() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot)
    if (!tracks_[slot].used) return slot;
  if (tracks_.size() == tracks_.capacity()) return tracks_.size();
  tracks_.emplace_back();
  return tracks_.size() - 1;
}

void JointTracker::end_lives() {
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    JointTrack& track = tracks_[slot];
    if (!track.used) continue;
    if (track.echo_share > kInView) track.last_detection_utime = now();
    const bool out = track.visible_share < kInView;
    if (out && !track.out_of_view) track.out_of_view_utime = now();
    if (out != track.out_of_view && track.confirmed_once)
      decide(track, out ? DecisionKind::coast : DecisionKind::resume, track.log_odds,
             out ? "left the field of view" : "back in the field of view");
    track.out_of_view = out;
    if (const char* reason = reason_to_end(track)) end(slot, DecisionKind::end, reason);
  }
}

const char* JointTracker::reason_to_end(const JointTrack& track) const {
  const double least = track.confirmed_once ? params_.life.end_log_odds : params_.life.tentative_log_odds;
  if (track.log_odds < least) return "too little evidence left";
  if (!track.out_of_view) return nullptr;
  if (!track.confirmed_once) return "left the field of view unconfirmed";
  const double out = core::seconds(now() - track.out_of_view_utime);
  return out > params_.life.coast_s ? "out of view for longer than the coast" : nullptr;
}

void JointTracker::end(std::size_t slot, DecisionKind kind, const char* reason) {
  JointTrack& track = tracks_[slot];
  track.used = false;
  likelihood_.set_existence(static_cast<int>(slot), 0.0);
  likelihood_.forget_claims(static_cast<int>(slot));
  if (!track.confirmed_once) return;
  if (kind == DecisionKind::end) retrodiction_.retire(track, now(), kSettledLogOdds);
  decide(track, kind, track.log_odds, reason);
}

void JointTracker::choose_report() {
  candidates_.clear();
  double tentative = 0.0;
  for (std::size_t slot = 0; slot < tracks_.size(); ++slot) {
    const JointTrack& track = tracks_[slot];
    const double p = track.used && !track.out_of_view ? track.existence() * track.visible_share : 0.0;
    if (track.log_odds < 0.0) tentative += p;
    if (p < kLeastReported) continue;
    candidates_.push_back({slot, p, track.moments.covariance(0, 0) + track.moments.covariance(1, 1)});
  }
  const double unseen = std::max(0.0, unseen_targets_ - tentative);
  const std::size_t count = report_.choose(candidates_, unseen, random_);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    JointTrack& track = tracks_[candidates_[i].slot];
    const bool report = i < count;
    if (report != track.reported)
      decide(track, report ? DecisionKind::confirm : DecisionKind::withdraw, track.log_odds,
             report ? "reporting it lowers the expected OSPA"
                    : "reporting it no longer lowers the expected OSPA");
    track.reported = report;
    track.confirmed_once |= report;
  }
}

// The sensor's figures from beams that no track owns and from sure tracks on
// straight lines.
void JointTracker::learn_sensor() {
  targets_.clear();
  for (const JointTrack& track : tracks_) {
    if (!track.used || track.cloud.curved || track.existence() < params_.report.min_existence) continue;
    if (target_samples_.size() == targets_.size()) target_samples_.emplace_back().reserve(kTargetSamples);
    auto& samples = target_samples_[targets_.size()];
    resample(track.cloud, samples);
    targets_.push_back({samples, track.existence()});
  }
  figures_.update(likelihood_.scans(), targets_);
  if (differ(figures_.figures(), likelihood_.scans().figures())) likelihood_.set_figures(figures_.figures());
}

void JointTracker::publish() {
  published_.clear();
  for (JointTrack& track : tracks_) {
    if (!track.used) continue;
    track.reported &= !track.out_of_view;
    publish_track(track);
  }
}

void JointTracker::publish_track(const JointTrack& track) {
  const bool coasting = track.confirmed_once && track.out_of_view;
  if (!track.reported && !coasting && track.existence() < kPublishedTentative) return;
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

void JointTracker::decide(const JointTrack& track, DecisionKind kind, double evidence,
                          const char* reason) const {
  if (log_) log_({now(), track.id, kind, evidence, reason});
}

}  // namespace lookout::tracking
