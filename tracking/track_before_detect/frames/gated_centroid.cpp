#include "tracking/track_before_detect/frames/gated_centroid.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kCellCentre = 0.5;

void check(const GatedCentroidParams& p) {
  core::require(std::isfinite(p.dct_db), "dct_db must be finite", p.dct_db);
  core::require_positive("target_area", p.target_area);
  core::require_positive("gate_radii", p.gate_radii);
  core::require_not_negative("gate_sigmas", p.gate_sigmas);
  core::require(p.iterations >= 1, "iterations must be >= 1", p.iterations);
  core::require_positive("variance", p.variance);
  core::require_positive("noise_density", p.noise_density);
}

CellWindow gate_about(const IntensityFrame& frame, const Eigen::Vector2d& centre, double half) {
  const auto bound = [](double value, int size) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(size)));
  };
  return {bound(centre.x() - half, frame.columns), bound(centre.x() + half + 1.0, frame.columns),
          bound(centre.y() - half, frame.rows), bound(centre.y() + half + 1.0, frame.rows)};
}

class GatedCentroid : public FrameTracker {
 public:
  explicit GatedCentroid(const GatedCentroidParams& params) : params_(params), tracks_(1) { check(params); }

  int batch_length() const override { return 1; }

  void add(std::int64_t id, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance) override {
    targets_.push_back({id, state, covariance, 0.0, 1.0, false});
  }

  void remove(std::int64_t id) override {
    std::erase_if(targets_, [id](const FrameTrack& target) { return target.id == id; });
  }

  const std::vector<std::vector<FrameTrack>>& process(std::span<const IntensityFrame> frames,
                                                      std::span<const double> steps) override {
    if (frames.size() != 1 || steps.size() != 1)
      throw std::invalid_argument("a batch must hold 1 frame with its step");
    check_frame(frames[0]);
    for (FrameTrack& target : targets_) {
      predict(target, steps[0]);
      if (const auto centroid = centroid_near(frames[0], target)) correct(target, *centroid);
      target.lost = !inside(frames[0], target.state.head<2>());
    }
    tracks_[0] = targets_;
    return tracks_;
  }

 private:
  static bool inside(const IntensityFrame& frame, const Eigen::Vector2d& p) {
    return p.x() >= 0.0 && p.x() < frame.columns && p.y() >= 0.0 && p.y() < frame.rows;
  }

  void predict(FrameTrack& target, double step) const {
    const Eigen::Matrix4d F = core::constant_velocity_transition(step);
    target.state = (F * target.state).eval();
    target.covariance =
        (F * target.covariance * F.transpose() + core::white_acceleration_noise(step, params_.noise_density))
            .eval();
  }

  /// Centroid of what is displayed in the gate, which moves onto it some times over. Nothing where the gate
  /// is dark.
  std::optional<Eigen::Vector2d> centroid_near(const IntensityFrame& frame, FrameTrack& target) {
    const double radius = std::sqrt(params_.target_area / std::numbers::pi);
    const double spread = std::sqrt(std::min(target.covariance(0, 0), target.covariance(1, 1)));
    const double threshold = displayed_threshold(frame.noise_level, params_.dct_db);
    Eigen::Vector2d centre = target.state.head<2>();
    for (int i = 0; i < params_.iterations; ++i) {
      const double half = params_.gate_radii * radius + (i == 0 ? params_.gate_sigmas * spread : 0.0);
      collect_displayed(frame, threshold, gate_about(frame, centre, half), 1, cells_);
      if (cells_.empty()) return std::nullopt;
      Eigen::Vector2d first{0, 0};
      target.intensity = 0.0;
      for (const DisplayedCell& cell : cells_) {
        first += cell.intensity * Eigen::Vector2d(cell.column + kCellCentre, cell.row + kCellCentre);
        target.intensity += cell.intensity;
      }
      centre = first / target.intensity;
    }
    return centre;
  }

  void correct(FrameTrack& target, const Eigen::Vector2d& measured) const {
    Eigen::Matrix2d S = target.covariance.topLeftCorner<2, 2>();
    S.diagonal().array() += params_.variance;
    const Eigen::Matrix<double, 4, 2> gain = target.covariance.leftCols<2>() * S.inverse();
    target.state += gain * (measured - target.state.head<2>());
    target.covariance -= gain * target.covariance.topRows<2>().eval();
    target.covariance = (0.5 * (target.covariance + target.covariance.transpose())).eval();
  }

  GatedCentroidParams params_;
  std::vector<FrameTrack> targets_;
  std::vector<DisplayedCell> cells_;
  std::vector<std::vector<FrameTrack>> tracks_;
};

}  // namespace

std::unique_ptr<FrameTracker> make_gated_centroid(const GatedCentroidParams& params) {
  return std::make_unique<GatedCentroid>(params);
}

}  // namespace lookout::tracking
