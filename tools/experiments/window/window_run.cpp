#include "tools/experiments/window/window_run.hpp"

#include <Eigen/Core>
#include <chrono>

#include "tools/experiments/tracking/nees.hpp"
#include "tools/experiments/window/least_squares_reference.hpp"
#include "tracking/metrics/ospa.hpp"

namespace lookout::tools {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Positions and velocities of a set of targets.
struct Elements {
  Points positions;
  Points velocities;
  void add(const Eigen::Vector4d& state) {
    positions.push_back(state.head<2>());
    velocities.push_back(state.tail<2>());
  }
};

Elements visible_truth(const core::GroundTruth& truth) {
  Elements elements;
  for (const auto& target : truth.targets) {
    if (!target.visible) continue;
    elements.positions.push_back(target.position);
    elements.velocities.push_back(target.velocity);
  }
  return elements;
}

}  // namespace

WindowAnswer estimate_window(csht::MotionEstimator& estimator, const std::vector<TimedScan>& scans) {
  WindowAnswer answer;
  for (const auto& timed : scans) {
    const auto start = std::chrono::steady_clock::now();
    const auto elements = estimator.update(timed.posed);
    answer.time_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    answer.elements.assign(elements.begin(), elements.end());
  }
  return answer;
}

Metrics score_window(const std::vector<TimedScan>& scans, const core::SonarParams& sonar,
                     const WindowAnswer& answer) {
  Elements found, reference;
  for (const auto& element : answer.elements) found.add(element.state());
  for (const auto& fit : least_squares_reference(scans, sonar)) reference.add(fit.state);
  const Elements truth = visible_truth(scans.back().truth);
  const bool count_right = found.positions.size() == truth.positions.size();
  tracking::Ospa ospa;
  Metrics metrics;
  metrics["position_ospa"] = ospa(truth.positions, found.positions).total;
  metrics["velocity_ospa"] = ospa(truth.velocities, found.velocities).total;
  if (count_right) metrics["velocity_ospa_count_right"] = metrics["velocity_ospa"];
  if (count_right && !answer.elements.empty())
    metrics["nees"] = mean_nees(scans.back().truth, answer.elements);
  metrics["count_correct"] = count_right ? 1.0 : 0.0;
  metrics["bound"] = ospa(truth.positions, reference.positions).total;
  metrics["velocity_bound"] = ospa(truth.velocities, reference.velocities).total;
  metrics["over_bound"] = metrics["position_ospa"].value - metrics["bound"].value;
  metrics["time_ms"] = answer.time_ms;
  return metrics;
}

}  // namespace lookout::tools
