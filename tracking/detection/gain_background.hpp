#pragma once

#include <vector>

#include "tracking/detection/detection_params.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// Divides an image by what is not a target: the gain of each beam and the level of each range, both fitted
/// anew to every ping, and what stands still in the sonar's own frame, learnt over many pings.
///
/// In nepers of power the model is x(beam, bin) = gain(beam) + level(bin) + structure(beam, bin) + speckle:
/// the first two by the means of rows and columns (an analysis of variance in two ways, exact in one pass),
/// the third by a pull towards each ping that is bounded, so that what passes through is not learnt. This
/// project's own.
class GainBackground {
 public:
  /// @throws std::invalid_argument for a parameter out of range.
  GainBackground(const BackgroundParams& params, ImageValues values);

  /// The image in power over its background, whose speckle is about 1 everywhere; valid until the next call.
  /// An image of another size than the last begins anew. @param intensity finite, not negative unless in
  /// decibels, num_beams x num_bins, row-major by beam.
  ImagePlane& normalise(const std::vector<double>& intensity, int num_beams, int num_bins);

  void forget() { pings_ = 0; }  ///< The next ping is the first: the structure is of another geometry.

 private:
  void take_logarithms(const std::vector<double>& intensity);
  void fit_gain_and_level();
  void divide();
  template <bool kLearns>
  void divide_row(int beam, float step);

  BackgroundParams params_;
  ImageValues values_;
  int pings_ = 0;                 ///< Behind `structure_`.
  ImagePlane log_;                ///< Power of the ping [nepers].
  ImagePlane structure_;          ///< What stands still [nepers].
  ImagePlane normalised_;         ///< Power over background.
  std::vector<float> row_;        ///< Logarithms of a beam.
  std::vector<float> level_;      ///< By bin [nepers].
  std::vector<double> bin_sums_;  ///< Of the logarithms over beams.
  std::vector<float> gain_;       ///< By beam [nepers].
};

}  // namespace lookout::tracking
