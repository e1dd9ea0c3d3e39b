#include "sonar_sim/simulated_sonar.hpp"

#include "sonar_sim/beam_model.hpp"
#include "sonar_sim/echo_noise.hpp"
#include "sonar_sim/return_selection.hpp"

namespace lookout::sonar_sim {
namespace {

void append(std::vector<BeamReturn>& all, const std::vector<BeamReturn>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

core::SonarScan empty_scan(const Ping& ping) {
  core::SonarScan scan;
  scan.T_body_sonar = ping.params.T_body_sonar;
  scan.first_bearing = ping.params.first_bearing;
  scan.bearing_step = ping.params.bearing_step;
  scan.max_range = ping.params.max_range;
  scan.num_beams = ping.params.num_beams;
  scan.fan = ping.params.fan;
  return scan;
}

}  // namespace

SimulatedSonar::SimulatedSonar(const SonarPlan& plan, const Scene& scene, const StreamKey& key,
                               std::int32_t sensor_id)
    : plan_(plan),
      targets_(scene.targets),
      num_scans_(num_scans(scene, plan)),
      sensor_id_(plan.sensor_id.value_or(sensor_id)),
      random_(open_stream(key, StreamPurpose::echoes)),
      sea_(plan.sea, key) {}

double SimulatedSonar::next_time() const {
  return plan_.first_scan + index_ * plan_.params.scan_period;
}

core::Pose2 SimulatedSonar::pose_on(const core::Pose2& T_earth_body) const {
  return core::compose(T_earth_body, plan_.params.T_body_sonar);
}

std::optional<core::SonarScan> SimulatedSonar::ping(const core::GroundTruth& truth,
                                                    const core::Pose2& T_earth_sonar) {
  const Ping ping = ping_at(next_time(), T_earth_sonar);
  core::SonarScan scan = empty_scan(ping);
  scan.utime = truth.utime;
  scan.sequence = index_++;
  scan.sensor_id = sensor_id_;
  scan.returns = in_order(listen(ping, truth));
  const ScanFate fate = sea_.draw_fate();
  if (fate == ScanFate::lost) return std::nullopt;
  if (fate == ScanFate::empty) scan.returns.clear();
  return scan;
}

Ping SimulatedSonar::ping_at(double time, const core::Pose2& T_earth_sonar) const {
  core::SonarParams params = params_at(plan_, time);
  apply_bursts(plan_.sea.bursts, time, params);
  return {params,        T_earth_sonar,         plan_.echo_range_sigma, plan_.quantise_bearing,
          plan_.clutter, plan_.returns_per_beam};
}

std::vector<BeamReturn> SimulatedSonar::listen(const Ping& ping, const core::GroundTruth& truth) {
  const bool point_sensor = ping.params.point_sensor();
  const auto visible = targets_in_view(ping, truth);
  const auto owners = point_sensor ? visible : beam_owners(visible, ping.returns_per_beam);
  auto heard =
      point_sensor ? draw_point_echoes(ping, owners, random_) : draw_beam_echoes(ping, owners, random_);
  sea_.add_returns(ping, heard);
  append(heard, point_sensor ? draw_point_clutter(ping, random_)
                             : draw_beam_clutter(ping, owners, static_cast<int>(visible.size()), random_));
  sea_.mark(heard);
  return point_sensor ? heard : select_returns(std::move(heard), ping.returns_per_beam, plan_.keep);
}

std::vector<BeamTarget> SimulatedSonar::targets_in_view(const Ping& ping, const core::GroundTruth& truth) {
  auto visible = visible_targets(ping, truth);
  for (auto& target : visible)
    for (const auto& plan : targets_)
      if (plan.id == truth.targets[target.target].id) target.snr_db = plan.snr_db;
  sea_.change_targets(ping, truth, visible);
  return visible;
}

}  // namespace lookout::sonar_sim
