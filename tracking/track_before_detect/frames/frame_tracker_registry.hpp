#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/files/yaml_reader.hpp"
#include "tracking/track_before_detect/frames/cell_expectation.hpp"
#include "tracking/track_before_detect/frames/frame_tracker.hpp"
#include "tracking/track_before_detect/frames/pdim.hpp"

namespace lookout::tracking {

/// Whether a sequence is differenced (PDIM) before it is tracked.
enum class Differencing {
  automatic,  ///< Where the frames hold a standing scene.
  on,
  off
};

/// The `tbd:` part of a configuration.
struct TbdParams {
  double dct_db = 5.0;                       ///< Displayed-cell threshold above the noise level [dB].
  Truncation truncation = Truncation::zero;  ///< See Truncation.
  Polarity polarity = Polarity::bright;      ///< See Polarity.
  std::optional<Eigen::Vector4d> start;      ///< x, y [px], vx, vy [px/frame]; absent: automatic initiation.
  double target_area = 96.0;                 ///< [px^2], > 0. The test target of docs/track_before_detect.md.
  Differencing differencing = Differencing::automatic;  ///< See Differencing.
  int frame_step = 1;                 ///< Frames between the two of a difference, Delta, >= 1.
  double frame_period = 1.0;          ///< Between frames [s], > 0.
  double start_position_sigma = 2.0;  ///< Of a given start [px], >= 0.
  double start_velocity_sigma = 0.2;  ///< [px/frame], >= 0.
  double pulse_length = 0.0;          ///< Of a sonar, see InstrumentParams [m], >= 0; 0: found in the images.
  double beam_width = 0.0;            ///< Likewise [rad], >= 0.
  double slowest = 0.0;               ///< Likewise [m/s], >= 0; 0: a tenth of the fastest.
  double birth_rate = 6.0;            ///< Likewise [1/s], > 0.
  double mark_time = 5.0;             ///< Likewise [s], >= 0.
  double max_speed = 10.0;            ///< Of automatically found targets [px/frame], > 0.
};

/// Overrides `params` with the keys that `map` holds, and calls map.finish().
/// @throws core::InputError on an unknown key or a value out of range.
void read_tbd_params(const core::YamlMap& map, TbdParams& params);

/// Names of the methods: h_pmht, i_h_pmht_4, i_h_pmht_1, immpda_ai.
std::span<const std::string_view> frame_tracker_names();

/// The method of that name for known targets. @throws std::invalid_argument for another name.
std::unique_ptr<FrameTracker> make_frame_tracker(std::string_view name, const TbdParams& params);

}  // namespace lookout::tracking
