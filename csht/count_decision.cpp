#include "csht/count_decision.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr double kPi = std::numbers::pi;

/// ln of the density of the detection's range and bearing [1/(m rad)] given a target at p_earth, times 2 pi.
/// Near the sonar the error across the line of sight spans many beams, so that clutter which crowds there is
/// weak evidence.
double log_detection_density(const WindowDetection& detection, const Eigen::Vector2d& p_earth) {
  const double bearing_variance = detection.cross_variance / (detection.range * detection.range);
  return -0.5 * std::log(detection.range_variance * bearing_variance) -
         0.5 * detection.distance(detection.p_earth - p_earth);
}

/// How many of the candidate's own detections the background makes.
double own_background(const Candidate& candidate, const HoughWindow& window) {
  double sum = 0.0;
  for (std::size_t s = 0; s < window.scans().size(); ++s)
    if (candidate.own[s] >= 0)
      sum += window.detections()[static_cast<std::size_t>(candidate.own[s])].background;
  return sum;
}

}  // namespace

CountDecision::CountDecision(const CountDecisionParams& params) : params_(params) {
  core::require(std::isfinite(params.min_evidence), "min_evidence must be finite", params.min_evidence);
  core::require(std::isfinite(params.offered_evidence), "offered_evidence must be finite",
                params.offered_evidence);
  core::require(params.min_support > 0, "min_support must be > 0", params.min_support);
  core::require(params.offered_support > 0, "offered_support must be > 0", params.offered_support);
  core::require_probability("relative_support", params.relative_support);
  core::require(params.clutter_regulariser > 0.0, "clutter_regulariser must be > 0",
                params.clutter_regulariser);
  core::require(params.foreign_return <= 0.0, "foreign_return must be <= 0", params.foreign_return);
  core::require(params.edge >= 0.0 && params.edge <= 0.5, "edge must be in [0, 0.5]", params.edge);
  core::require(params.targets_in_view > 0.0, "targets_in_view must be > 0", params.targets_in_view);
  core::require(params.prior_speed > 0.0, "prior_speed must be > 0", params.prior_speed);
  core::require_not_negative("velocity_sigma", params.velocity_sigma);
}

void CountDecision::prepare(const HoughWindow& window) {
  num_beams_ = window.sonar().num_beams;
  reported_.assign(window.scans().size() * static_cast<std::size_t>(num_beams_), -1);
  for (std::size_t k = 0; k < window.detections().size(); ++k) {
    const auto& detection = window.detections()[k];
    if (detection.beam < 0 || detection.beam >= num_beams_) continue;
    const auto row = static_cast<std::size_t>(detection.scan) * static_cast<std::size_t>(num_beams_);
    reported_[row + static_cast<std::size_t>(detection.beam)] = static_cast<int>(k);
  }
}

double CountDecision::log_evidence(const Candidate& candidate, const HoughWindow& window, double epoch,
                                   const std::vector<char>& free, double num_free) const {
  std::array<View, kMaxWindowScans> views;
  int in_view = 0;
  for (std::size_t s = 0; s < window.scans().size(); ++s) {
    views[s] = view(candidate, window, s, epoch);
    in_view += views[s].visible ? 1 : 0;
  }
  const Rates rates = this->rates(candidate, window, in_view, num_free);
  double sum = log_prior_volume(candidate, window.sonar());
  for (std::size_t s = 0; s < window.scans().size(); ++s) {
    if (!views[s].visible) continue;
    if (candidate.own[s] < 0) {
      sum += without_detection(window, s, views[s].point, free, rates);
      continue;
    }
    const auto& detection = window.detections()[static_cast<std::size_t>(candidate.own[s])];
    sum += rates.detection + log_background(detection) +
           log_detection_density(detection, candidate.position(detection.time - epoch));
  }
  return sum;
}

CountDecision::View CountDecision::view(const Candidate& candidate, const HoughWindow& window,
                                        std::size_t scan, double epoch) const {
  const auto& at = window.scans()[scan];
  View view;
  view.point = core::observe(window.sonar(), at.T_earth_sonar, candidate.position(at.time - epoch));
  view.visible = candidate.own[scan] >= 0 || view.point.visible();
  return view;
}

CountDecision::Rates CountDecision::rates(const Candidate& candidate, const HoughWindow& window, int in_view,
                                          double num_free) const {
  const auto& sonar = window.sonar();
  const double others = num_free - own_background(candidate, window) + params_.clutter_regulariser;
  const double beams = static_cast<double>(window.scans().size()) * sonar.num_beams;
  const double p_detection = (candidate.support + 0.5) / (in_view + 1.0);
  const double p_false = std::min(others / beams, 1.0 - 1.0 / beams);
  const double step = sonar.sector() / sonar.num_beams;
  const double clutter_density = others / (beams * (sonar.fan ? step : sonar.bearing_step) * sonar.max_range);
  return {std::log(p_detection / (2.0 * kPi * clutter_density)), std::log1p(-p_detection),
          std::log1p(-p_detection) - (sonar.point_sensor() ? 0.0 : std::log1p(-p_false)), 1.0 - p_detection};
}

/// Evidence [nats] of a scan without a detection of the candidate's own: from its beam and, where it is near
/// the beam's edge, from the neighbouring beam, whichever is greater.
double CountDecision::without_detection(const HoughWindow& window, std::size_t scan,
                                        const core::SonarPoint& point, const std::vector<char>& free,
                                        const Rates& rates) const {
  const auto& sonar = window.sonar();
  if (sonar.point_sensor()) return rates.miss;
  const double term = beam_term(window, scan, point.beam, point.range, free, rates);
  const double off = (point.bearing - sonar.beam_centre(point.beam)) / sonar.beam_width(point.beam);
  const int neighbour = point.beam + (off > 0.0 ? 1 : -1);
  if (std::abs(off) < 0.5 - params_.edge || neighbour < 0 || neighbour >= num_beams_) return term;
  return std::max(term, beam_term(window, scan, neighbour, point.range, free, rates));
}

double CountDecision::beam_term(const HoughWindow& window, std::size_t scan, int beam, double range,
                                const std::vector<char>& free, const Rates& rates) const {
  const int reported =
      reported_[scan * static_cast<std::size_t>(num_beams_) + static_cast<std::size_t>(beam)];
  if (reported < 0) return rates.silence;
  const auto index = static_cast<std::size_t>(reported);
  // A nearer target that is accepted already owns the beam: the scan says nothing of this candidate.
  if (!free[index] && window.detections()[index].range < range) return 0.0;
  // What is dense in a target's beam returns as well as elsewhere, whenever the target does not.
  const double excess = 1.0 - window.detections()[index].background;
  return excess > 0.0 ? std::log(std::exp(params_.foreign_return) + rates.missed * excess)
                      : params_.foreign_return;
}

/// ln of prior density x (2 pi)^2 sqrt(det C), the volume that the fit leaves to the state.
double CountDecision::log_prior_volume(const Candidate& candidate, const core::SonarParams& sonar) const {
  const double sector = std::min(sonar.sector(), 2.0 * kPi);
  const double area = 0.5 * sector * sonar.max_range * sonar.max_range;
  return 0.5 * std::log(candidate.covariance.determinant()) + 2.0 * std::log(2.0 * kPi) +
         std::log(params_.targets_in_view / area) + log_velocity_density(candidate.state.tail<2>());
}

/// ln of the prior density of a velocity [1/(m/s)^2].
double CountDecision::log_velocity_density(const Eigen::Vector2d& velocity) const {
  const double variance = params_.velocity_sigma * params_.velocity_sigma;
  if (variance > 0.0) return -std::log(2.0 * kPi * variance) - 0.5 * velocity.squaredNorm() / variance;
  return -std::log(kPi * params_.prior_speed * params_.prior_speed);
}

double existence_of(const Candidate& candidate, const CountDecisionParams& params) {
  const double log_odds = candidate.log_evidence - (candidate.offered ? params.offered_evidence : 0.0);
  return 1.0 / (1.0 + std::exp(-log_odds));
}

bool CountDecision::accepts(const Candidate& candidate, int best_support) const {
  if (!candidate.offered) return accepts_as_new(candidate, best_support);
  return enough(candidate, params_.offered_support, params_.offered_evidence, best_support);
}

bool CountDecision::accepts_as_new(const Candidate& candidate, int best_support) const {
  return enough(candidate, params_.min_support, params_.min_evidence, best_support);
}

bool CountDecision::enough(const Candidate& candidate, int support, double evidence, int best_support) const {
  return candidate.support >= support && candidate.log_evidence > evidence &&
         candidate.support >= params_.relative_support * best_support;
}

}  // namespace lookout::csht
