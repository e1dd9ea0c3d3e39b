#pragma once

#include <optional>
#include <string>

namespace lookout::core {
class YamlMap;
}

namespace lookout::tracking {

/// What the values of an image are.
enum class ImageValues {
  amplitude,  ///< Proportional to sound pressure.
  power,      ///< Proportional to its square.
  decibel     ///< 10 log10 of power.
};

/// How large the echo of a point is, and which peaks are one echo. Distances are in echo widths, so that one
/// set holds at any resolution.
struct EchoParams {
  /// Half-power length of the pulse in range [m], > 0; absent: the grain of the speckle, at least a bin.
  std::optional<double> pulse_length;
  /// Half-power width of a beam [rad], > 0; absent: the grain of the speckle, at least the beams' spacing.
  std::optional<double> beam_width;
  /// Two peaks are one echo unless the level between them falls so far below the weaker [dB], > 0. Speckle
  /// on one echo seldom does.
  double valley_db = 6.0;
  /// Level of the beam pattern's sidelobes one beam width off the axis, falling by 6 dB an octave beyond
  /// [dB], < 0. An unshaded line array has -8.9; the rest is a margin for speckle.
  double sidelobe_db = -5.0;
};

/// The level that a peak is compared with.
struct ReferenceParams {
  std::string method = "cell_averaging";  ///< One of reference_level_names().
  double guard = 2.0;                     ///< Echo widths to either side that are left out, >= 1.
  double range_extent = 8.0;              ///< Echo widths beyond the guard along range, >= 1.
  double beam_extent = 3.0;               ///< Echo widths beyond the guard over beams, >= 1.
  double quantile = 0.75;                 ///< Of ordered_statistic, in (0, 1). [Rohling1983]
  int samples = 32;                       ///< Cells that ordered_statistic looks at, >= 8.
};

/// Gain and background that are learnt.
struct BackgroundParams {
  /// Over how many pings what stands still in the sonar's own frame becomes background, >= 1, or 0: never.
  double memory_pings = 100.0;
  /// How far one ping may pull it [nepers of power], > 0, so that what passes through is not learnt.
  double pull = 1.5;
};

/// The stated false-alarm rate, and how the law behind it is learnt.
struct FalseAlarmParams {
  /// False returns a beam and ping, in (0, 0.5]. The trackers gain more by weak echoes than they lose by
  /// false ones: of .01 to .4 the higher rates were the better ones (docs/detect.md); .1 keeps large fans
  /// cheap.
  double rate = 0.1;
  double memory_pings = 100.0;  ///< Of the law of the background's peaks, >= 1.
  int zones = 4;                ///< At most so many stretches of range with a law of their own, >= 1.
};

/// From sonar images to returns. One set for all instruments: lengths and widths follow from the image.
struct DetectionParams {
  ImageValues values = ImageValues::amplitude;  ///< What the image holds.
  EchoParams echo;                              ///< How large an echo is.
  BackgroundParams background;                  ///< What is learnt of gain and level.
  ReferenceParams reference;                    ///< What a peak is compared with.
  FalseAlarmParams false_alarm;                 ///< How often noise may give a return.
  int max_returns = 1000;  ///< Of a ping; the strongest are kept, the rest counted. In [1, 2700]: a message.
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const DetectionParams& params);

/// Overrides `params` with the keys of a configuration's `detect:` part, and calls map.finish().
/// @throws core::InputError on an unknown key, a value out of range, or a key without effect.
void read_detection_params(const core::YamlMap& map, DetectionParams& params);

}  // namespace lookout::tracking
