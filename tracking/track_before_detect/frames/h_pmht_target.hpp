#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracking/track_before_detect/frames/h_pmht.hpp"

/// One target inside the histogram PMHT; an implementation detail of make_h_pmht.
namespace lookout::tracking {

/// What one E-step says of a target at one frame.
struct SyntheticMeasurement {
  bool valid = false;              ///< Whether the target got any intensity.
  Eigen::Vector2d position{0, 0};  ///< Eq. (12).
  Eigen::Vector2d variance{0, 0};  ///< Diagonal of R~, Eq. (13).
  double noise_scale = 1.0;        ///< P_t / ||Z_t||: Q~ = noise_scale Q, Eq. (14).
};

/// A target over one batch: index 0 is the last frame before it.
class HPmhtTarget {
 public:
  /// Starts at the last frame before the batch, with the mixing proportion `weight`.
  HPmhtTarget(const HPmhtParams& params, std::int64_t id, const Eigen::Vector4d& state,
              const Eigen::Matrix4d& covariance, double weight);

  /// Dead-reckons over the batch: the first trajectory estimate.
  void start_batch(std::span<const double> steps);
  /// Position model at frame t = 1 .. T for the E-step.
  CellModel model(std::size_t t) const;
  /// Takes the sums of an E-step at frame t; `expectation` is that frame's.
  void take(std::size_t t, const Expectation& expectation, const TargetSums& sums, double noise_scale);
  /// Kalman smoother over the batch, then R (and Q) about the new trajectory: Eq. (16)-(23).
  void maximise(std::span<const double> steps);
  /// Carries the last frame over to the next batch.
  void end_batch();

  FrameTrack track(std::size_t t) const;   ///< As it is at frame t of the batch.
  std::int64_t id() const { return id_; }  ///< As it was added.
  bool lost() const { return lost_; }      ///< Whether it is given up.
  void lose() { lost_ = true; }            ///< Gives it up.
  /// Its mixing proportion at frame t, Eq. (5); may be written.
  double& weight(std::size_t t) { return epochs_[t].weight; }
  /// Intensity at frame t that belongs to it, Eq. (15).
  double responsibility(std::size_t t) const { return epochs_[t].sums.responsibility; }

 private:
  struct Epoch {
    Eigen::Vector4d smoothed{0, 0, 0, 0};                  ///< The trajectory estimate x_t.
    Eigen::Vector4d filtered{0, 0, 0, 0};                  ///< y_t|t.
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< P_t|t, in units of noise_scale.
    Eigen::Matrix4d predicted = Eigen::Matrix4d::Zero();   ///< P_t|t-1, likewise.
    Eigen::Vector2d variance{1, 1};                        ///< R_t [px^2].
    double weight = 0.0;                                   ///< pi_t.
    TargetSums sums;
    SyntheticMeasurement measurement;
  };
  void filter(const Epoch& before, Epoch& epoch, double step) const;
  void smooth(Epoch& epoch, const Epoch& after, double step) const;
  void learn_variance(Epoch& epoch, const Eigen::Vector2d& old_mean) const;
  void learn_process_noise(std::span<const double> steps);
  Eigen::Matrix4d process_noise(double step) const;

  HPmhtParams params_;
  std::int64_t id_;
  bool lost_ = false;
  Eigen::Matrix4d start_covariance_;              ///< Of epoch 0, in true units.
  std::optional<Eigen::Matrix4d> printed_noise_;  ///< Q of Eq. (23), once learned.
  std::vector<Epoch> epochs_;
};

}  // namespace lookout::tracking
