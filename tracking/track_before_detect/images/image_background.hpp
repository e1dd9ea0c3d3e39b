#pragma once

#include <span>
#include <vector>

#include "core/sonar_image.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Parameters of the level that a sonar image is divided by.
struct ImageBackgroundParams {
  double half_window = 0.5;   ///< Of the running median over range, either side [m], > 0.
  int least_half_window = 7;  ///< And at least so many bins, >= 0.
  double prior_pings = 6.0;   ///< Pings that the level of range and beam counts for in a cell, > 0.
  int most_pings = 100;       ///< Pings that a cell remembers, >= 1.
  int swift_pings = 12;       ///< Pings of the swift memory, which everything enters, >= 1.
  double least_level = 0.02;  ///< Of the image's mean, below which no level falls, > 0.
};

/// The level of every cell, learnt ping by ping: of its range and beam together (the median over beams at
/// each range, times the gain of each beam), and of the cell itself, which takes in bottom, walls and
/// standing highlights. Cells that a target covers are not learnt. Where the sonar moves the memory moves
/// with it.
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
  void reset();  ///< Forgets all levels.

  /// Level by which a cell of the last image was divided.
  double level(int bin, int beam) const { return level_[frame_.index(bin, beam)]; }

 private:
  void learn_profile(const core::SonarImage& image);
  void smooth_profile(double range_step);
  void learn_gains(const core::SonarImage& image);
  void follow(const core::PosedImage& posed);
  void shift(const core::PosedImage& posed);
  double floor_of(const core::SonarImage& image) const;

  ImageBackgroundParams params_;
  std::vector<double> median_, profile_, gain_, scratch_;  ///< By bin, by bin, by beam.
  std::vector<float> mean_, count_, swift_;                ///< By cell: memory, its pings, swift memory.
  std::vector<float> moved_mean_, moved_count_, moved_swift_;
  std::vector<double> level_;
  std::vector<double> image_;  ///< Intensities of the last image.
  std::vector<char> held_;     ///< By cell, whether it is not learnt.
  IntensityFrame frame_;
  core::PosedImage last_;  ///< Pose and geometry of the memory; holds no intensities.
  float offset_ = 0.5f;    ///< Of the cell that the memory is moved to.
  bool started_ = false;
  int pings_ = 0;
};

}  // namespace lookout::tracking
