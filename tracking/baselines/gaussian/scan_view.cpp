#include "tracking/baselines/gaussian/scan_view.hpp"

#include <numbers>

#include "core/field_of_view.hpp"
#include "core/parameter_check.hpp"
#include "csht/scan_to_detections.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSpreadSigmas = 3.0;  // How far the beams about a target are looked at.
constexpr double kLeastRange = 1e-3;   // Share of max_range: where bearings lose their meaning.
constexpr double kLeastShare = 1e-12;

double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Squared standard deviation of a position along a unit vector.
double variance_along(const Eigen::Matrix2d& covariance, const Eigen::Vector2d& direction) {
  return direction.dot(covariance * direction);
}

}  // namespace

void ScanViewParams::validate() const {
  core::require_inner_share("hidden", hidden);
  core::require_share("shadowed", shadowed);
}

ScanView::ScanView(const ScanViewParams& params)
    : params_(params), gate_(chi_square_gate(params.gate_probability, 2)) {
  params_.validate();
}

void ScanView::look(const core::PosedScan& scan, const core::SonarParams& sonar,
                    const csht::SensorFigures& figures) {
  sonar_ = sonar;
  figures_ = figures;
  sonar_.range_sigma = figures.range_sigma;
  sonar_.bearing_sigma = figures.bearing_sigma;
  T_earth_sonar_ = scan.T_earth_sonar;
  csht::scan_to_detections(scan, 0, detections_);
  returns_.clear();
  first_return_.assign(static_cast<std::size_t>(sonar_.num_beams), -1);
  next_return_.clear();
  const double sector = sonar_.sector();
  const double alarms =
      sonar_.point_sensor() ? figures.clutter_per_scan : figures.false_alarm_probability * sonar_.num_beams;
  for (const auto& detection : detections_) {
    const double range = std::max(detection.range, kLeastRange * sonar_.max_range);
    const int beam = std::clamp(detection.beam, 0, sonar_.num_beams - 1);
    // False returns are even over range and bearing, so that their density over the plane falls as 1 / range.
    returns_.push_back({{detection.p_earth, position_noise(detection, sonar_)},
                        alarms / (sonar_.max_range * sector * range),
                        beam});
    int& first = first_return_[static_cast<std::size_t>(beam)];
    next_return_.push_back(first);
    first = static_cast<int>(returns_.size()) - 1;
  }
  clear_claims();
}

double ScanView::field_area() const {
  return 0.5 * sonar_.sector() * sonar_.max_range * sonar_.max_range;
}

BeamSpread ScanView::spread_of(const GaussianTarget& target) const {
  const core::SonarPoint point = core::observe(sonar_, T_earth_sonar_, target.mean().head<2>());
  const Eigen::Matrix2d covariance = target.covariance().topLeftCorner<2, 2>();
  const double azimuth = T_earth_sonar_.heading + point.bearing;
  const Eigen::Vector2d along = core::from_polar(1.0, azimuth);
  const double range_variance = variance_along(covariance, along) + std::pow(figures_.range_sigma, 2);
  const double cross = std::sqrt(variance_along(covariance, {-along.y(), along.x()}));
  const double range = std::max(point.range, kLeastRange * sonar_.max_range);
  const double bearing_sigma = std::min(std::hypot(cross / range, figures_.heading_sigma), std::numbers::pi);
  const double place = sonar_.place_of(point.bearing);
  const double width = sonar_.beam_width(static_cast<int>(place));
  return {place, std::max(bearing_sigma / width, kLeastShare),
          normal_cdf((sonar_.max_range - point.range) / std::sqrt(range_variance))};
}

/// The beam of an index that may lie beyond the sector: -1 there, unless the sector is the whole circle.
int ScanView::beam_at(int index) const {
  if (index >= 0 && index < sonar_.num_beams) return index;
  const double sector = sonar_.sector();
  if (sector < 2.0 * std::numbers::pi - 0.5 * sonar_.bearing_step) return -1;
  return (index % sonar_.num_beams + sonar_.num_beams) % sonar_.num_beams;
}

/// Calls `visit(beam, probability)` for the beams of the sector that the target may be in.
template <typename Visit>
void ScanView::for_each_beam(const BeamSpread& spread, const Visit& visit) const {
  const double reach = std::min(kSpreadSigmas * spread.sigma, 0.5 * sonar_.num_beams);
  const int first = static_cast<int>(std::floor(spread.place - reach));
  const int last = static_cast<int>(std::floor(spread.place + reach));
  double below = 0.0;
  for (int index = first; index <= last; ++index) {
    const double up_to = index == last ? 1.0 : normal_cdf((index + 1 - spread.place) / spread.sigma);
    const int beam = beam_at(index);
    if (beam >= 0) visit(static_cast<std::size_t>(beam), up_to - below);
    below = up_to;
  }
}

double ScanView::in_view(const BeamSpread& spread) const {
  double sum = 0.0;
  for_each_beam(spread, [&](std::size_t /*beam*/, double share) { sum += share; });
  return spread.in_range * sum;
}

void ScanView::clear_claims() {
  claimed_.assign(static_cast<std::size_t>(sonar_.num_beams), 0.0);
}

double ScanView::odds_of(std::size_t beam, const BeamClaim& claim) const {
  double sum = 0.0;
  for (int j = first_return_[beam]; j >= 0; j = next_return_[static_cast<std::size_t>(j)])
    sum += claim.existence * return_ratio(claim.target, returns_[static_cast<std::size_t>(j)]);
  return sum;
}

void ScanView::claim(const BeamSpread& spread, const BeamClaim& claim) {
  for_each_beam(spread, [&](std::size_t beam, double /*share*/) { claimed_[beam] += odds_of(beam, claim); });
}

double ScanView::miss_ratio(const BeamSpread& spread, const BeamClaim& own) const {
  double change = 0.0;
  for_each_beam(spread, [&](std::size_t beam, double share) {
    const double others = std::max(0.0, claimed_[beam] - odds_of(beam, own));
    change += share * (1.0 - beam_ratio(beam, others / (1.0 + others)));
  });
  return std::max(kLeastShare, 1.0 - spread.in_range * change);
}

// [Yan2018] V as a likelihood ratio: a beam with a target in it never carries a false alarm. Averaged over
// what an empty beam returns, it and `return_ratio` give 1, whatever `hidden` is: no track grows on clutter.
double ScanView::beam_ratio(std::size_t beam, double owned_by_others) const {
  const double seen = 1.0 - params_.hidden;
  if (sonar_.point_sensor() || !params_.beam_evidence)
    return seen * figures_.miss_probability + params_.hidden;
  if (first_return_[beam] < 0)
    return seen * figures_.miss_probability / (1.0 - figures_.false_alarm_probability) + params_.hidden;
  return owned_by_others * params_.shadowed + (1.0 - owned_by_others) * params_.hidden;
}

double ScanView::return_ratio(const GaussianTarget& target, const ViewedReturn& seen) const {
  // So near the sonar every bearing fits, and the target would take the near returns of all beams.
  const Eigen::Vector2d p_earth_sonar(T_earth_sonar_.north, T_earth_sonar_.east);
  if ((target.mean().head<2>() - p_earth_sonar).norm() < figures_.range_sigma) return 0.0;
  if (squared_distance(target, seen.measurement) > gate_) return 0.0;
  return (1.0 - params_.hidden) * detection_probability() * density(target, seen.measurement) /
         seen.clutter_density;
}

}  // namespace lookout::tracking
