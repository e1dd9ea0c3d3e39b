#include "sonar_sim/sonar_simulator.hpp"

#include <algorithm>

namespace lookout::sonar_sim {
namespace {

constexpr double kLargestReportShare = 0.25;  // of the scan period

template <class State>
void append(std::vector<State>& all, const std::vector<State>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<SimulatedSonar> make_sonars(const Scene& scene, const PlatformPlan& platform, StreamKey key) {
  std::vector<SimulatedSonar> sonars;
  for (const SonarPlan* plan : all_sonars(platform)) {
    key.sonar = sonars.size();
    sonars.emplace_back(*plan, scene, key, platform.node_id + static_cast<std::int32_t>(key.sonar));
  }
  return sonars;
}

double report_offset(const PlatformPlan& platform) {
  double offset = SonarSimulator::kReportOffset;
  for (const SonarPlan* plan : all_sonars(platform))
    offset = std::min(offset, kLargestReportShare * plan->params.scan_period);
  return offset;
}

}  // namespace

SonarSimulator::SonarSimulator(const Scene& scene, std::uint64_t seed, std::uint64_t run,
                               std::size_t platform)
    : scene_(scene),
      platform_index_(platform),
      motion_(scene_.platforms.at(platform).vehicle),
      sonars_(make_sonars(scene_, scene_.platforms[platform], {seed, run, platform})),
      navigation_random_(open_stream({seed, run, platform}, StreamPurpose::navigation)),
      pose_errors_(scene_.platforms[platform].vehicle.navigation.drift,
                   open_stream({seed, run, platform}, StreamPurpose::pose_drift)),
      report_offset_(report_offset(scene_.platforms[platform])) {
  const PlatformPlan& plan = scene_.platforms[platform];
  if (plan.image) images_.emplace(plan.sonar, *plan.image, StreamKey{seed, run, platform});
}

std::optional<SimulatedScan> SonarSimulator::next() {
  std::vector<core::VehicleState> states_of_lost_scans;
  while (SimulatedSonar* sonar = next_sonar()) {
    SimulatedScan simulated;
    const bool lost = !ping(*sonar, simulated);
    if (lost) {
      append(states_of_lost_scans, simulated.states_before);
      append(states_of_lost_scans, simulated.states_after);
      continue;
    }
    simulated.states_before.insert(simulated.states_before.begin(), states_of_lost_scans.begin(),
                                   states_of_lost_scans.end());
    return simulated;
  }
  return std::nullopt;
}

SimulatedSonar* SonarSimulator::next_sonar() {
  SimulatedSonar* earliest = nullptr;
  for (auto& sonar : sonars_) {
    if (sonar.over()) continue;
    if (earliest == nullptr || sonar.next_time() < earliest->next_time()) earliest = &sonar;
  }
  return earliest;
}

/// One ping with the reports around it. @return whether its scan left the
/// sonar.
bool SonarSimulator::ping(SimulatedSonar& sonar, SimulatedScan& simulated) {
  const double time = sonar.next_time();
  report(std::max(0.0, time - report_offset_));
  simulated.states_before = arrived_by(time);
  simulated.truth = truth_at(scene_, platform(), motion_, time);
  simulated.T_earth_sonar = sonar.pose_on(motion_.at(time).T_earth_body);
  auto scan = sonar.ping(simulated.truth, simulated.T_earth_sonar);
  report(time + report_offset_);
  simulated.states_after = arrived_by(time_of_next_ping() - report_offset_);
  if (scan) simulated.scan = std::move(*scan);
  if (images_ && &sonar == &sonars_.front()) simulated.image = make_image(simulated);
  return scan.has_value();
}

double SonarSimulator::time_of_next_ping() const {
  double time = sonars_.front().next_time();
  for (const auto& sonar : sonars_) time = std::min(time, sonar.next_time());
  return time;
}

void SonarSimulator::report(double time) {
  // The reports around another sonar's ping may serve this one too.
  const std::int64_t utime = core::microseconds(time);
  if (utime <= last_report_) return;
  last_report_ = utime;
  const NavigationFaults& faults = platform().vehicle.navigation;
  const core::Pose2 error = pose_errors_.at(time);
  const double jitter = navigation_random_.uniform(-faults.time_jitter, faults.time_jitter);
  core::VehicleState state = motion_.at(std::max(0.0, time + jitter));
  core::Pose2& pose = state.T_earth_body;
  pose.north += error.north + navigation_random_.gaussian(faults.position_sigma);
  pose.east += error.east + navigation_random_.gaussian(faults.position_sigma);
  pose.heading =
      core::wrap_to_pi(pose.heading + (error.heading + navigation_random_.gaussian(faults.heading_sigma)));
  const bool lost = navigation_random_.bernoulli(faults.loss_probability);
  if (!lost) reports_.push_back({core::seconds(state.utime) + faults.delay, state});
}

std::vector<core::VehicleState> SonarSimulator::arrived_by(double time) {
  std::vector<core::VehicleState> arrived;
  while (!reports_.empty() && reports_.front().arrival <= time + 1e-9) {
    arrived.push_back(reports_.front().state);
    reports_.pop_front();
  }
  return arrived;
}

core::SonarImage SonarSimulator::make_image(const SimulatedScan& simulated) {
  std::vector<double> snr_db;
  for (const auto& target : simulated.truth.targets)
    for (const auto& plan : scene_.targets)
      if (plan.id == target.id) snr_db.push_back(plan.snr_db.value_or(platform().image->snr_db));
  core::SonarImage image = images_->draw(simulated.T_earth_sonar, simulated.truth, snr_db);
  image.sequence = simulated.scan.sequence;
  image.sensor_id = simulated.scan.sensor_id;
  return image;
}

}  // namespace lookout::sonar_sim
