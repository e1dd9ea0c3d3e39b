#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/random.hpp"

/// A seeded stand-in for the aircraft videos of [Pakfiliz2018], which are not published: what Table 2 states
/// of each (frame size, area, speed, contrast, noise) is kept, the rest is ours
/// (docs/track_before_detect.md).
namespace lookout::sonar_sim {

/// One row of [Pakfiliz2018] Table 2.
struct VideoScenario {
  int number = 1;         ///< 1 .. 8.
  int frame_step = 4;     ///< Frames between two samples, Delta.
  int size = 250;         ///< Side of the square frame [px].
  double area = 240.0;    ///< Of the aircraft [px^2].
  double speed = 2.5;     ///< [px/frame].
  double noise_db = 1.0;  ///< PDIM noise level, 10 log10.
  double snr_db = 8.8;    ///< PDIM signal-to-noise ratio, 10 log10.

  double noise_level() const;  ///< Linear PDIM noise level.
  double contrast() const;     ///< Grey levels between sky and aircraft: (noise level x SNR)^2.
};
/// The eight scenarios of [Pakfiliz2018], in its order.
const std::array<VideoScenario, 8>& video_scenarios();

/// How the video is made harder than the paper's.
struct VideoStandInParams {
  int num_samples = 21;         ///< Frames taken: one more than scans, >= 2.
  double cloud_sigma = 4.0;     ///< Of the cloud texture [grey levels], >= 0.
  double cloud_drift = 0.3;     ///< [px/frame].
  double tree_sigma = 8.0;      ///< Of the tree line in the lowest tenth [grey levels], >= 0.
  double jitter = 0.25;         ///< Standard deviation of the tree line's shift in each frame [px], >= 0.
  double camera_sigma = 0.5;    ///< Camera noise [grey levels], >= 0.
  double sway = 4.0;            ///< Amplitude of the half sinusoid across the path [px], >= 0.
  double max_heading = 0.2094;  ///< The path's heading is uniform within +- this [rad], >= 0 (12 degrees).
  int num_movers = 0;           ///< Small dark discs that cross the path, >= 0.
  double mover_area = 12.0;     ///< [px^2], > 0.
  double mover_offset =
      5.0;  ///< Standard deviation per axis of where a mover crosses, from the target [px], >= 0.
};
VideoStandInParams plain_video();  ///< As the paper describes it: nothing harder.
VideoStandInParams hard_video();   ///< Jitter 1 px and three movers.

/// Axis-aligned box [px].
struct PixelBox {
  Eigen::Vector2d low{0, 0}, high{0, 0};  ///< Corners [px].
  /// Whether the point lies in it, border included.
  bool contains(const Eigen::Vector2d& p) const {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
  }
};

/// One rendered sample.
struct VideoSample {
  std::vector<double> grey;            ///< size * size grey levels, row by row.
  Eigen::Vector2d centroid{0, 0};      ///< Of the whole aircraft [px].
  Eigen::Vector2d new_centroid{0, 0};  ///< Of the cells that it covers and did not at the sample before.
  PixelBox box;                        ///< Bounding box of the aircraft.
};

/// The video of one scenario and seed.
class VideoStandIn {
 public:
  /// @throws std::invalid_argument where a parameter is out of range.
  VideoStandIn(const VideoScenario& scenario, const VideoStandInParams& params, core::Random& random);

  const VideoScenario& scenario() const { return scenario_; }  ///< As given.
  int num_samples() const { return params_.num_samples; }      ///< Samples of the video.
  /// Aircraft centre at sample k (frame k * frame_step) [px] and its mean velocity there [px/frame].
  Eigen::Vector2d position(int sample) const;
  Eigen::Vector2d velocity(int sample) const;  ///< Mean velocity of the aircraft at sample k [px/frame].
  /// Renders sample k; camera noise and jitter come from `random`.
  VideoSample render(int sample, core::Random& random) const;

 private:
  struct Mover {
    Eigen::Vector2d crossing{0, 0};
    Eigen::Vector2d velocity{0, 0};  ///< [px/frame]
    int sample = 0;                  ///< When it is at its crossing.
  };
  using Coverage = std::vector<double>;

  void lay_path(core::Random& random);
  void lay_movers(core::Random& random);
  void paint_clouds(core::Random& random);
  void paint_trees(core::Random& random);
  std::vector<double> background(int sample, core::Random& random) const;
  Coverage aircraft(int sample) const;
  Coverage movers(int sample) const;

  VideoScenario scenario_;
  VideoStandInParams params_;
  double length_ = 1.0;  ///< Of the fuselage [px].
  Eigen::Vector2d start_{0, 0}, direction_{1, 0};
  std::vector<Mover> movers_;
  int texture_columns_ = 0;
  std::vector<double> clouds_;  ///< texture_columns_ x size.
  std::vector<double> trees_;   ///< texture_columns_ x size.
};

/// Whether the silhouette of unit length, nose along +x, tail fin towards -y, covers the point.
bool silhouette_covers(const Eigen::Vector2d& p);

}  // namespace lookout::sonar_sim
