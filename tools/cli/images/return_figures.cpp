#include "tools/cli/images/return_figures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/field_of_view.hpp"
#include "core/frames.hpp"
#include "core/pose_history.hpp"
#include "core/sonar_limits.hpp"

namespace lookout::tools {
namespace {

constexpr int kEnoughReturns = 20;

/// Where a target is in the sonar's frame.
struct Seen {
  double range = 0.0, bearing = 0.0;
};

bool within(const Seen& a, double range, double bearing, const ReturnGate& gate) {
  return std::abs(a.range - range) <= gate.range &&
         std::abs(core::wrap_to_pi(a.bearing - bearing)) <= gate.bearing;
}

/// The pose at each scan from the states of a recording, fed as they come.
class Poses {
 public:
  Poses(const core::Recording& recording, double max_gap)
      : recording_(recording), history_(core::microseconds(max_gap)) {}

  std::optional<core::Pose2> at(std::int64_t utime) {
    if (recording_.is_fixed) return core::Pose2{};
    while (next_ < recording_.vehicle.size() && !history_.reaches(utime))
      history_.add(recording_.vehicle[next_++]);
    return history_.at(utime);
  }

 private:
  const core::Recording& recording_;
  core::PoseHistory history_;
  std::size_t next_ = 0;
};

/// The sums behind the figures.
class Tally {
 public:
  explicit Tally(const ReturnGate& gate) : gate_(gate) {}

  void add(const core::SonarScan& scan, const std::vector<Seen>& targets) {
    ++figures_.scans;
    figures_.returns += static_cast<int>(scan.returns.size());
    for (const auto& one : scan.returns) {
      const auto holds = [&](const Seen& target) { return within(target, one.range, one.bearing, gate_); };
      if (std::none_of(targets.begin(), targets.end(), holds)) ++figures_.false_returns;
    }
    for (const Seen& target : targets)
      if (is_alone(target, targets)) look_for(target, scan);
  }

  ReturnFigures finish() {
    if (figures_.found == 0) return figures_;
    const double n = figures_.found;
    figures_.range_bias = range_ / n;
    figures_.bearing_bias = bearing_ / n;
    figures_.range_sigma = std::sqrt(range_squares_ / n);
    figures_.bearing_sigma = std::sqrt(bearing_squares_ / n);
    return figures_;
  }

 private:
  bool is_alone(const Seen& target, const std::vector<Seen>& targets) const {
    const ReturnGate both{2.0 * gate_.range, 2.0 * gate_.bearing};
    return std::count_if(targets.begin(), targets.end(), [&](const Seen& other) {
             return within(target, other.range, other.bearing, both);
           }) == 1;
  }

  void look_for(const Seen& target, const core::SonarScan& scan) {
    ++figures_.targets;
    const core::SonarReturn* best = nullptr;
    for (const auto& one : scan.returns)
      if (within(target, one.range, one.bearing, gate_) && (!best || one.intensity > best->intensity))
        best = &one;
    if (best == nullptr) return;
    ++figures_.found;
    const double range = best->range - target.range,
                 bearing = core::wrap_to_pi(best->bearing - target.bearing);
    range_ += range;
    bearing_ += bearing;
    range_squares_ += range * range;
    bearing_squares_ += bearing * bearing;
  }

  ReturnGate gate_;
  ReturnFigures figures_;
  double range_ = 0.0, range_squares_ = 0.0, bearing_ = 0.0, bearing_squares_ = 0.0;
};

/// The targets of a truth that a scan could have seen.
std::vector<Seen> targets_in_view(const core::GroundTruth& truth, const core::SonarParams& params,
                                  const core::Pose2& T_earth_sonar) {
  std::vector<Seen> seen;
  for (const auto& target : truth.targets) {
    const core::SonarPoint point = core::observe(params, T_earth_sonar, target.position);
    if (target.visible && point.visible()) seen.push_back({point.range, point.bearing});
  }
  return seen;
}

}  // namespace

double ReturnFigures::miss_probability() const {
  return (targets - found + 0.5) / (targets + 1.0);
}

double ReturnFigures::false_per_scan() const {
  return scans == 0 ? 0.0 : static_cast<double>(false_returns) / scans;
}

ReturnFigures measure_returns(const core::Recording& recording, const core::SonarParams& sensor,
                              const ReturnGate& gate) {
  Tally tally(gate);
  if (!recording.new_clocks.empty()) return tally.finish();
  Poses poses(recording, sensor.max_pose_gap);
  auto truth = recording.truth.begin();
  for (const auto& scan : recording.scans) {
    while (truth != recording.truth.end() && truth->utime < scan.utime) ++truth;
    if (truth == recording.truth.end()) break;
    const auto pose = poses.at(scan.utime);
    if (truth->utime != scan.utime || !pose) continue;
    const core::SonarParams params = core::with_geometry_of(scan, sensor);
    tally.add(scan, targets_in_view(*truth, params, core::compose(*pose, scan.T_body_sonar)));
  }
  return tally.finish();
}

core::SonarParams with_measured(const core::SonarParams& sensor, const ReturnFigures& figures) {
  if (figures.found < kEnoughReturns) return sensor;
  core::SonarParams measured = sensor;
  measured.miss_probability = figures.miss_probability();
  measured.false_alarm_probability.reset();
  measured.clutter_per_scan = figures.false_per_scan();
  using Limits = core::SonarLimits;
  measured.range_sigma = std::clamp(figures.range_sigma, Limits::kMinRangeSigma, Limits::kMaxRangeSigma);
  measured.bearing_sigma = figures.bearing_sigma;
  return measured;
}

}  // namespace lookout::tools
