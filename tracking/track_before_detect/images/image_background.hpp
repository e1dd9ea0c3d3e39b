#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sonar_image.hpp"
#include "tracking/detection/image_plane.hpp"
#include "tracking/detection/speckle_grain.hpp"
#include "tracking/track_before_detect/images/level_memory.hpp"
#include "tracking/track_before_detect/images/memory_choice.hpp"
#include "tracking/track_before_detect/images/wide_level.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Parameters of the level that a sonar image is divided by.
struct ImageBackgroundParams {
  double half_window = 0.5;   ///< Of the running median over range, either side [m], > 0.
  int least_half_window = 7;  ///< And at least so many bins, >= 0.
  double prior_pings = 6.0;   ///< Pings that the level of range and beam counts for in a cell, > 0.
  int most_pings = 100;       ///< Pings that a cell remembers, >= 1.
  int swift_pings = 12;       ///< Pings of the swift memory, which everything enters, >= 1.
  double spill = 0.7;         ///< Least share of a neighbour's level, where the memory moved, in [0, 1].
  double hold = 8.0;          ///< For which a cell is kept for a target on end [s], > 0; then it is learnt: a
                              ///< target passes, in the sonar's frame and in the earth's.
  double slowest = 0.3;       ///< Target that passes [m/s], > 0: a cell is kept for no longer than it takes.
  double beam_width = 0.0;    ///< Of an echo at half its amplitude [rad], >= 0; 0: as the speckle shows.
  int least_hold_pings = 16;  ///< And at least for so many pings, >= 1.
  double least_share = 0.7;   ///< Of the usual level, below which no memory brings a cell, > 0: what leaves a
                              ///< shadow is no target.
  double least_level = 0.02;  ///< Of the image's mean, below which no level falls, > 0.
};

/// The level of every cell, learnt ping by ping: of its range and beam together (the median over beams at
/// each range, times the gain of each beam), and of the cell itself in units of that, which takes in bottom,
/// walls and standing highlights. Cells that a target covers are not learnt. The cells' memory is held
/// twice, in the sonar's frame and, moved with the sonar, in the earth's: by place the greater of the two
/// levels counts, unless the pings have shown that it is wrong; in the sonar's frame no more than spans many
/// beams, for a target may go along.
class ImageBackground {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit ImageBackground(const ImageBackgroundParams& params = {});

  /// The image over its level, columns being bins and rows beams: about 1 without targets; valid until the
  /// next call. The image is to be finite, not negative and of the size it states.
  const IntensityFrame& normalise(const core::PosedImage& posed);
  /// Learns the image last normalised, but for the cells of `kept`; those of `standing` take their level from
  /// what they have held of late.
  void learn(std::span<const CellWindow> kept, std::span<const CellWindow> standing);

  /// Level by which a cell of the last image was divided.
  double level(int bin, int beam) const { return level_[frame_.index(bin, beam)]; }

 private:
  void learn_profile(const core::SonarImage& image);
  void smooth_profile(double range_step);
  void learn_gains(const core::SonarImage& image);
  void collect_over_profile(const core::SonarImage& image, int beam, float least);
  void find_usual(const core::SonarImage& image);
  void expect_still();
  void expect_moved();
  void combine();
  void measure_spread(const core::SonarImage& image);
  float most_kept(const CellWindow& window) const;
  void follow(const core::PosedImage& posed);
  void shift(const core::PosedImage& posed);
  double floor_of(const core::SonarImage& image) const;

  ImageBackgroundParams params_;
  std::vector<double> median_, profile_, gain_, loudness_, scratch_;  ///< By bin, by bin, by beam, by beam.
  std::vector<float> ratio_;   ///< By cell: the last image over that level.
  LevelMemory moved_, still_;  ///< Of the earth's frame and of the sonar's.
  WideLevel wide_;             ///< Of still_.
  MemoryChoice choice_;
  SpeckleGrain grain_;
  ImagePlane plane_;  ///< For grain_.
  std::vector<float> expected_, along_, still_expected_;
  std::vector<double> level_;
  std::vector<float> hold_;            ///< By cell, pings that it may be kept for, or how it is learnt.
  std::vector<Eigen::Vector2f> from_;  ///< By cell, where it was before the sonar moved [cells].
  IntensityFrame frame_;
  core::PosedImage last_;   ///< Pose and geometry of the memory; holds no intensities.
  bool has_moved_ = false;  ///< Whether the memory has been moved.
  bool started_ = false;
  int pings_ = 0;
  double interval_ = 0.0;  ///< Between the last two images [s].
  std::int64_t last_utime_ = 0;
};

}  // namespace lookout::tracking
