#include "tracking/track_before_detect/images/cell_evidence.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr double kDetectionRatio = 2.0;  // of likelihoods, above which a frame counts as a detection
constexpr double kCellSpread = 0.25;     // [cells^2] that a place is spread by, cells being coarse
constexpr double kNoPrior = 1e-5;
constexpr double kReachSigmas = 2.5;  // of a target's filtered signature around its centre
constexpr double kGateSigmas = 3.0;
constexpr float kScoreMemory = 0.8f;  // of the scales' scores, per frame
constexpr float kScaleMargin = 1.0f;  // [ln] by which another scale must be better

CellWindow clipped(CellWindow window, const IntensityFrame& frame) {
  window.first_column = std::max(window.first_column, 0);
  window.last_column = std::min(window.last_column, frame.columns);
  window.first_row = std::max(window.first_row, 0);
  window.last_row = std::min(window.last_row, frame.rows);
  return window;
}

}  // namespace

double probability_of(double odds) {
  return odds / (1.0 + odds);
}

double CellEvidence::log_ratio(double log_probability) const {
  const double bounded = std::clamp(log_probability, std::log(params_.least_probability), 0.0);
  return std::log(params_.rank_exponent) + (params_.rank_exponent - 1.0) * bounded;
}

double CellEvidence::likelihood_ratio(const ScaleSpace& scales, const CellGeometry& geometry,
                                      const CellTrack& track, const Eigen::Vector2d& start) const {
  const CellView view = geometry.observe(track.state.head<2>());
  if (!view.inside) return 1.0;
  return std::max(params_.rank_exponent, mean_ratio(scales, track, view, start));
}

/// The mean, over where the target may be about `start`, of the ratio of the cell there. Not the greatest of
/// them: that of a place without a target would be above 1 on average.
double CellEvidence::mean_ratio(const ScaleSpace& scales, const CellTrack& track, const CellView& view,
                                const Eigen::Vector2d& start) const {
  const ScaledFrame& scaled = scales.scales()[static_cast<std::size_t>(track.scale)];
  const CellView own = scaled.to_scale(view);
  Eigen::Matrix2d S = own.jacobian * track.covariance.topLeftCorner<2, 2>() * own.jacobian.transpose();
  S.diagonal().array() += kCellSpread;
  const Eigen::Matrix2d S_inverse = S.inverse();
  const double density = 0.5 / std::numbers::pi / std::sqrt(S.determinant());
  const Eigen::Vector2d reach = (kGateSigmas * S.diagonal().array().sqrt())
                                    .min(kReachSigmas * scales.params().filter.sigma.array() + 1.0);
  const CellWindow window = clipped(window_about(scaled.to_scale(start), reach), scaled.frame);
  double sum = 0.0;
  for (int row = window.first_row; row < window.last_row; ++row)
    for (int column = window.first_column; column < window.last_column; ++column) {
      const Eigen::Vector2d off = Eigen::Vector2d(column + 0.5, row + 0.5) - own.cell;
      const double prior = density * std::exp(-0.5 * off.dot(S_inverse * off));
      if (prior < kNoPrior) continue;
      sum += prior * std::exp(log_ratio(scales.cell_log_probability(scaled, column, row)));
    }
  return sum;
}

double CellEvidence::first_existence(const ScaleSpace& scales, const Candidate& candidate,
                                     double step) const {
  const TailLaw& tail = scales.scales()[static_cast<std::size_t>(candidate.scale)].tail;
  const double births = std::min(params_.births_per_frame, params_.birth_rate * step);
  const double prior = births / std::max(1.0, static_cast<double>(tail.blocks()));
  const double choices = std::log(static_cast<double>(scales.scales().size()));
  return probability_of(prior * std::exp(log_ratio(candidate.log_probability + choices)));
}

void CellEvidence::judge_existence(CellTrack& track, double ratio, double time) const {
  const double own = track.measured ? ratio : params_.rank_exponent;
  track.existence =
      std::min(params_.most_existence, probability_of(own * track.existence / (1.0 - track.existence)));
  if (own > kDetectionRatio) track.last_detection_time = time;
}

void judge_scale(const ScaleSpace& space, const CellView& view, CellTrack& track) {
  const auto scales = space.scales().size();
  for (std::size_t s = 0; s < scales; ++s) {
    const auto now = static_cast<float>(space.scales()[s].log_probability_at(view.cell));
    float& score = track.scale_score[s];
    score = track.age <= 1 ? now : kScoreMemory * score + (1.0f - kScoreMemory) * now;
  }
  const auto first = track.scale_score.begin();
  const auto best = std::min_element(first, first + static_cast<std::ptrdiff_t>(scales));
  if (*best < track.scale_score[static_cast<std::size_t>(track.scale)] - kScaleMargin)
    track.scale = static_cast<int>(best - first);
}

}  // namespace lookout::tracking
