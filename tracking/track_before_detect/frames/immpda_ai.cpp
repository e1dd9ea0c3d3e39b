#include "tracking/track_before_detect/frames/immpda_ai.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"
#include "tracking/track_before_detect/frames/cell_expectation.hpp"

namespace lookout::tracking {
namespace {

void check(const ImmpdaAiParams& p) {
  core::require(p.block_size >= 1, "block_size must be >= 1", p.block_size);
  core::require(p.target_area > 0.0, "target_area must be > 0", p.target_area);
  core::require(p.slow_density > 0.0, "slow_density must be > 0", p.slow_density);
  core::require(p.agile_density > 0.0, "agile_density must be > 0", p.agile_density);
  core::require(p.stay_probability > 0.0 && p.stay_probability < 1.0, "stay_probability must be in (0, 1)",
                p.stay_probability);
  core::require(p.gate > 0.0, "gate must be > 0", p.gate);
  core::require(p.detection_probability > 0.0 && p.detection_probability < 1.0,
                "detection_probability must be in (0, 1)", p.detection_probability);
  core::require(p.gate_probability > 0.0 && p.gate_probability <= 1.0, "gate_probability must be in (0, 1]",
                p.gate_probability);
  core::require(p.mean_factor > 0.0, "mean_factor must be > 0", p.mean_factor);
  core::require(p.max_amplitude_ratio > 0.0, "max_amplitude_ratio must be > 0", p.max_amplitude_ratio);
}

/// One motion model's belief.
struct Mode {
  double probability = 0.5;
  Eigen::Vector4d state{0, 0, 0, 0};
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
};
using Modes = std::array<Mode, 2>;

/// Mean and covariance of a mixture of modes with the given weights (sum 1).
Mode merge(const Modes& modes, const std::array<double, 2>& weights) {
  Mode merged;
  for (std::size_t i = 0; i < 2; ++i) merged.state += weights[i] * modes[i].state;
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector4d spread = modes[i].state - merged.state;
    merged.covariance += weights[i] * (modes[i].covariance + spread * spread.transpose());
  }
  return merged;
}

struct PointTarget {
  std::int64_t id = 0;
  Modes modes;
  bool lost = false;
};

/// The points of one frame and what they mean.
struct PointFrame {
  std::vector<AmplitudePoint> points;
  double threshold = 1.0;  ///< In units of the noise level.
  double noise_level = 1.0;
  double target_power = 1.0;  ///< d, the target's power over that of the noise.
  double density = 0.0;       ///< Points per px^2.
};

class ImmpdaAi : public FrameTracker {
 public:
  explicit ImmpdaAi(const ImmpdaAiParams& params) : params_(params) { check(params); }

  int batch_length() const override { return 1; }

  void add(std::int64_t id, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance) override {
    PointTarget target;
    target.id = id;
    target.modes.fill({0.5, state, covariance});
    targets_.push_back(target);
  }

  void remove(std::int64_t id) override {
    std::erase_if(targets_, [id](const PointTarget& target) { return target.id == id; });
  }

  const std::vector<std::vector<FrameTrack>>& process(std::span<const IntensityFrame> frames,
                                                      std::span<const double> steps) override {
    if (frames.size() != 1 || steps.size() != 1)
      throw std::invalid_argument("a batch must hold 1 frame with its step, got " +
                                  std::to_string(frames.size()));
    take_frame(frames[0]);
    tracks_.resize(1);
    tracks_[0].clear();
    for (PointTarget& target : targets_) {
      mix(target.modes);
      for (std::size_t i = 0; i < 2; ++i) update(target.modes[i], density_of(i), steps[0]);
      normalise(target.modes);
      report(target);
    }
    return tracks_;
  }

 private:
  double density_of(std::size_t mode) const {
    return mode == 0 ? params_.slow_density : params_.agile_density;
  }

  double measurement_variance() const {
    return params_.target_area / (4.0 * std::numbers::pi) + params_.block_size * params_.block_size / 12.0;
  }

  void take_frame(const IntensityFrame& frame) {
    check_frame(frame);
    if (columns_ == 0) columns_ = frame.columns, rows_ = frame.rows;
    if (frame.columns != columns_ || frame.rows != rows_)
      throw std::invalid_argument("the frames are " + std::to_string(columns_) + " x " +
                                  std::to_string(rows_) + ", got one of " + std::to_string(frame.columns) +
                                  " x " + std::to_string(frame.rows));
    double mean = 0.0;
    for (const double value : frame.values) mean += value;
    mean /= static_cast<double>(frame.values.size());
    const double threshold = params_.mean_threshold ? params_.mean_factor * mean
                                                    : displayed_threshold(frame.noise_level, params_.dct_db);
    frame_.noise_level = frame.noise_level;
    frame_.threshold = threshold / frame.noise_level;
    extract_points(frame, params_.block_size, threshold, frame_.points);
    frame_.density = static_cast<double>(frame_.points.size()) / (static_cast<double>(columns_) * rows_);
    learn_target_power();
  }

  /// The brightest point stands for the target: its power over the noise, at least that of the threshold.
  void learn_target_power() {
    double brightest = frame_.threshold;
    for (const AmplitudePoint& point : frame_.points)
      brightest = std::max(brightest, point.amplitude / frame_.noise_level);
    frame_.target_power = brightest * brightest;
  }

  /// Interaction of the two modes by the Markov chain.
  void mix(Modes& modes) const {
    const double stay = params_.stay_probability;
    const Modes before = modes;
    for (std::size_t j = 0; j < 2; ++j) {
      std::array<double, 2> weights{};
      for (std::size_t i = 0; i < 2; ++i) weights[i] = before[i].probability * (i == j ? stay : 1.0 - stay);
      const double total = weights[0] + weights[1];
      for (double& weight : weights) weight /= total;
      modes[j] = merge(before, weights);
      modes[j].probability = total;
    }
  }

  /// Predicts one mode, associates the gated points and updates; its probability takes the likelihood.
  void update(Mode& mode, double noise_density, double step) {
    const Eigen::Matrix4d F = core::constant_velocity_transition(step);
    mode.state = F * mode.state;
    mode.covariance =
        F * mode.covariance * F.transpose() + noise_density * core::white_acceleration_noise(step, 1.0);
    Eigen::Matrix2d S = mode.covariance.topLeftCorner<2, 2>();
    S.diagonal().array() += measurement_variance();
    const Eigen::Matrix2d S_inverse = S.inverse();
    const double found = params_.detection_probability * params_.gate_probability;
    const double peak = 1.0 / (2.0 * std::numbers::pi * std::sqrt(S.determinant()));
    const double missed =
        (1.0 - found) * std::max(frame_.density, 1.0 / (columns_ * static_cast<double>(rows_)));
    double total = missed;
    Eigen::Vector2d innovation{0, 0};
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const AmplitudePoint& point : frame_.points) {
      const Eigen::Vector2d residual = point.position - mode.state.head<2>();
      const double distance = residual.dot(S_inverse * residual);
      if (distance > params_.gate) continue;
      const double weight = params_.detection_probability * peak * std::exp(-0.5 * distance) * ratio(point);
      total += weight;
      innovation += weight * residual;
      spread += weight * residual * residual.transpose();
    }
    mode.probability *= total;
    correct(mode, S_inverse, missed / total, innovation / total, spread / total);
  }

  double ratio(const AmplitudePoint& point) const {
    return std::min(params_.max_amplitude_ratio, amplitude_ratio(point.amplitude / frame_.noise_level,
                                                                 frame_.threshold, frame_.target_power));
  }

  /// The update of probabilistic data association with its spread of innovations.
  void correct(Mode& mode, const Eigen::Matrix2d& S_inverse, double missed, const Eigen::Vector2d& innovation,
               const Eigen::Matrix2d& second_moment) const {
    const Eigen::Matrix<double, 4, 2> gain = mode.covariance.leftCols<2>() * S_inverse;
    const Eigen::Matrix2d spread = second_moment - innovation * innovation.transpose();
    mode.state += gain * innovation;
    mode.covariance +=
        -(1.0 - missed) * gain * mode.covariance.topRows<2>() + gain * spread * gain.transpose();
    mode.covariance = (0.5 * (mode.covariance + mode.covariance.transpose())).eval();
  }

  static void normalise(Modes& modes) {
    const double total = modes[0].probability + modes[1].probability;
    for (Mode& mode : modes) mode.probability = total > 0.0 ? mode.probability / total : 0.5;
  }

  void report(PointTarget& target) {
    const Mode merged = merge(target.modes, {target.modes[0].probability, target.modes[1].probability});
    const Eigen::Vector4d& x = merged.state;
    target.lost |= x[0] < 0.0 || x[0] >= columns_ || x[1] < 0.0 || x[1] >= rows_;
    tracks_[0].push_back({target.id, x, merged.covariance, 0.0, 1.0, target.lost});
  }

  ImmpdaAiParams params_;
  int columns_ = 0, rows_ = 0;
  PointFrame frame_;
  std::vector<PointTarget> targets_;
  std::vector<std::vector<FrameTrack>> tracks_;
};

double block_sum(const IntensityFrame& frame, int size, int column, int row) {
  double sum = 0.0;
  for (int y = row; y < row + size; ++y)
    for (int x = column; x < column + size; ++x) sum += frame.at(x, y);
  return sum;
}

}  // namespace

void extract_points(const IntensityFrame& frame, int block_size, double threshold,
                    std::vector<AmplitudePoint>& points) {
  points.clear();
  const double half = 0.5 * block_size;
  for (int row = 0; row + block_size <= frame.rows; row += block_size)
    for (int column = 0; column + block_size <= frame.columns; column += block_size) {
      const double mean = block_sum(frame, block_size, column, row) / (block_size * block_size);
      if (mean >= threshold) points.push_back({{column + half, row + half}, mean});
    }
}

double amplitude_ratio(double amplitude, double threshold, double d) {
  const double excess = amplitude * amplitude - threshold * threshold;
  return std::exp(0.5 * excess * d / (1.0 + d)) / (1.0 + d);
}

std::unique_ptr<FrameTracker> make_immpda_ai(const ImmpdaAiParams& params) {
  return std::make_unique<ImmpdaAi>(params);
}

}  // namespace lookout::tracking
