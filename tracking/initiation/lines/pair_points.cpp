#include "tracking/initiation/lines/pair_points.hpp"

#include <tuple>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

PairFormation::PairFormation(const SpeedLimits& speeds, std::int64_t max_pairs, double margin)
    : speeds_(speeds), max_pairs_(max_pairs), margin_(margin) {
  speeds.validate();
  core::require_not_negative("gate_margin", margin);
}

void PairFormation::add(const PlotWindow& window, int older, int newer, const Eigen::Vector2d& origin) {
  const Plot& a = window.plot(older);
  const Plot& b = window.plot(newer);
  if (!in_annulus(b.position - a.position, b.time - a.time, speeds_, margin_)) return;
  if (++total_ > max_pairs_) return;
  pairs_.push_back({older, newer, *line_through(a.position - origin, b.position - origin)});
}

const std::vector<PairPoint>& PairFormation::form(const PlotWindow& window, int scan,
                                                  const Eigen::Vector2d& origin) {
  pairs_.clear();
  const bool gated = std::isfinite(speeds_.max);
  const double radius = speeds_.max * (window.time(scan) - window.time(scan - 1)) + margin_;
  if (gated) index_.build(window, scan);
  for (int older = window.first(scan - 1); older < window.end(scan - 1) && !exceeded(); ++older) {
    if (gated) {
      index_.near(window.plot(older).position, radius, [&](int newer) { add(window, older, newer, origin); });
    } else {
      for (int newer = window.first(scan); newer < window.end(scan) && !exceeded(); ++newer)
        add(window, older, newer, origin);
    }
  }
  return pairs_;
}

void sort_by_theta(std::vector<PairPoint>& pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const PairPoint& a, const PairPoint& b) {
    return std::tuple(a.line.theta, a.older, a.newer) < std::tuple(b.line.theta, b.older, b.newer);
  });
}

std::string PairFormation::refusal() const {
  return "more than " + std::to_string(max_pairs_) + " pairs of plots in one window; " +
         "use vct, or a smaller window or speed range";
}

}  // namespace lookout::tracking
