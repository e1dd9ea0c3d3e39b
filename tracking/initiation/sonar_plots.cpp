#include "tracking/initiation/sonar_plots.hpp"

#include <algorithm>

#include "core/field_of_view.hpp"
#include "csht/scan_to_detections.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMeanForgets = 0.05;    // Of the mean number of returns, per scan.
constexpr double kNearestShare = 0.001;  // Of the range; nearer, the density of clutter grows no more.
// At a few metres the range error reaches to the sonar itself, where all bearings meet and clutter crowds:
// the density is taken so many sigmas nearer than the plot, else crossing clutter starts tracks there.
constexpr double kNearerSigmas = 2.0;

}  // namespace

std::span<const Plot> SonarPlots::of(const core::PosedScan& scan, const core::SonarParams& configured) {
  const core::SonarParams sonar = core::with_geometry_of(scan.scan, configured);
  if (!has_origin_) {
    has_origin_ = true;
    p_earth_origin_ = {scan.T_earth_sonar.north, scan.T_earth_sonar.east};
    returns_per_scan_ = static_cast<double>(scan.scan.returns.size());
  }
  csht::scan_to_detections(scan, 0, detections_);
  returns_per_scan_ += kMeanForgets * (static_cast<double>(detections_.size()) - returns_per_scan_);
  const double sector = sonar.sector();
  const double per_range = std::max(returns_per_scan_, 1.0) / (sector * sonar.max_range);
  plots_.clear();
  for (const core::Detection& detection : detections_) {
    Plot plot;
    plot.position = detection.p_earth - p_earth_origin_;
    plot.noise = position_noise(detection, sonar);
    const double nearer = detection.range - kNearerSigmas * sonar.range_sigma;
    plot.clutter_density = per_range / std::max(nearer, kNearestShare * sonar.max_range);
    plots_.push_back(plot);
  }
  return plots_;
}

}  // namespace lookout::tracking
