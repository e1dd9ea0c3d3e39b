#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "core/frames.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_params.hpp"
#include "sonar_sim/image/image_sea_plan.hpp"

/// What the raw intensity image of a forward-looking sonar looks like: the echo
/// of a point target in beams and range bins, and the level of the background.
/// The image holds amplitudes.
namespace lookout::sonar_sim {

/// The image part of a scene. Beams are the sonar's own.
struct ImagePlan {
  int num_bins = 300;                     ///< >= 1.
  double first_range = 0.25;              ///< Centre of bin 0 [m], > 0.
  double range_step = 0.5;                ///< [m], > 0.
  double beam_null = core::radians(1.5);  ///< First null of the beam pattern [rad], > 0.
  double pulse_sigma = 0.55;              ///< Of the Gaussian range pulse [m], > 0.
  std::optional<double> shape = 4.0;      ///< Of the K-distributed background, > 0; absent: Rayleigh.
  double noise_level = 1.0;               ///< Background rms amplitude far away, > 0.
  double reverberation_level = 4.0;       ///< Added to it near the sonar, >= 0.
  double reverberation_range = 30.0;      ///< Where that has fallen to half [m], > 0.
  double snr_db = 10.0;                   ///< 20 log10(peak amplitude / local rms) of targets
                                          ///< without their own.
  bool tapered = false;                   ///< Beams with a Hann taper: side lobes at -31 dB in
                                          ///< place of -13, the first null where it was.
  int bits = 16;                          ///< Of the instrument's integers, in [1, 16].
  ImageSeaPlan sea;                       ///< What a real sea adds.

  /// rms amplitude of the background at `range` [m].
  double background_level(double range) const;
};

/// @throws std::invalid_argument naming the value out of range.
void check(const ImagePlan& plan);

/// One point target in the image.
struct ImageTarget {
  double range = 0.0;     ///< [m]
  double bearing = 0.0;   ///< [rad], sonar frame.
  double snr_db = 10.0;   ///< See ImagePlan.
  double phase = 0.0;     ///< Of the echo at this ping [rad].
  double strength = 1.0;  ///< Factor of the amplitude at this ping, >= 0.
};

/// An image of the right size without intensities. @throws as `check`.
core::SonarImage empty_image(const core::SonarParams& sonar, const ImagePlan& plan);

/// Amplitude share of a target in beams that are off by `bearing` [rad]; 1 at
/// 0. With u = bearing / first null, sinc(u) of a uniform aperture, or sinc(2
/// u) / (1 - 4 u^2) of one with a Hann taper twice as wide.
double beam_response(const ImagePlan& plan, double bearing);
/// Amplitude share in bins that are off by `range` [m]; 1 at 0.
double pulse_response(const ImagePlan& plan, double range);

/// Adds the complex echo of a target to `field`, laid out like an image's
/// intensity.
void add_echo(const core::SonarImage& image, const ImagePlan& plan, const ImageTarget& target,
              std::vector<std::complex<double>>& field);

}  // namespace lookout::sonar_sim
