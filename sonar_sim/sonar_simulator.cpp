#include "sonar_sim/sonar_simulator.hpp"

#include <algorithm>

#include "sonar_sim/beam_model.hpp"
#include "sonar_sim/echo_noise.hpp"
#include "sonar_sim/image_noise.hpp"

namespace lookout::sonar_sim {
namespace {

/// One index of the random stream for each (run, platform, purpose).
std::uint64_t stream_index(std::uint64_t run, std::size_t platform, std::uint64_t purpose) {
  return (static_cast<std::uint64_t>(platform) * 2 + purpose) << 40 | run;
}

}  // namespace

SonarSimulator::SonarSimulator(const Scene& scene, std::uint64_t seed, std::uint64_t run,
                               std::size_t platform)
    : scene_(scene),
      platform_index_(platform),
      motion_(scene_.platforms.at(platform).vehicle),
      random_(seed, core::RandomStream::simulator, stream_index(run, platform, 0)),
      navigation_random_(seed, core::RandomStream::simulator, stream_index(run, platform, 1)),
      image_random_(seed, core::RandomStream::images, stream_index(run, platform, 0)) {}

std::optional<SimulatedScan> SonarSimulator::next() {
  if (index_ >= num_scans(scene_, platform())) return std::nullopt;
  const double period = platform().sonar.params.scan_period;
  const double time = index_ * period;

  SimulatedScan simulated;
  report(std::max(0.0, time - kReportOffset));
  simulated.states_before = arrived_by(time);
  simulated.truth = truth_at(scene_, platform(), motion_, time);
  simulated.T_earth_sonar =
      core::compose(motion_.at(time).T_earth_body, platform().sonar.params.T_body_sonar);
  simulated.scan = make_scan(simulated.truth, simulated.T_earth_sonar);
  if (platform().image) simulated.image = make_image(simulated.truth, simulated.T_earth_sonar);
  report(time + kReportOffset);
  simulated.states_after = arrived_by(time + period - kReportOffset);
  ++index_;
  return simulated;
}

void SonarSimulator::report(double time) {
  const NavigationFaults& faults = platform().vehicle.navigation;
  const double jitter = navigation_random_.uniform(-faults.time_jitter, faults.time_jitter);
  core::VehicleState state = motion_.at(std::max(0.0, time + jitter));
  state.T_earth_body.north += navigation_random_.gaussian(faults.position_sigma);
  state.T_earth_body.east += navigation_random_.gaussian(faults.position_sigma);
  state.T_earth_body.heading =
      core::wrap_to_pi(state.T_earth_body.heading + navigation_random_.gaussian(faults.heading_sigma));
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

core::SonarScan SonarSimulator::make_scan(const core::GroundTruth& truth, const core::Pose2& T_earth_sonar) {
  const SonarPlan& sonar = platform().sonar;
  core::SonarScan scan;
  scan.utime = truth.utime;
  scan.sequence = index_;
  scan.sensor_id = platform().node_id;
  scan.T_body_sonar = sonar.params.T_body_sonar;
  scan.first_bearing = sonar.params.first_bearing;
  scan.bearing_step = sonar.params.bearing_step;
  scan.max_range = sonar.params.max_range;
  scan.num_beams = sonar.params.num_beams;
  const auto visible = visible_targets(sonar.params, T_earth_sonar, truth);
  scan.returns = sonar.params.point_sensor() ? draw_point_returns(sonar, visible, random_)
                                             : draw_beam_returns(sonar, beam_owners(visible),
                                                                 static_cast<int>(visible.size()), random_);
  return scan;
}

core::SonarImage SonarSimulator::make_image(const core::GroundTruth& truth,
                                            const core::Pose2& T_earth_sonar) {
  std::vector<double> snr_db;
  for (const auto& target : truth.targets)
    for (const auto& plan : scene_.targets)
      if (plan.id == target.id) snr_db.push_back(plan.snr_db.value_or(platform().image->snr_db));
  core::SonarImage image =
      draw_image(platform().sonar.params, *platform().image, T_earth_sonar, truth, snr_db, image_random_);
  image.sequence = index_;
  image.sensor_id = platform().node_id;
  return image;
}

}  // namespace lookout::sonar_sim
