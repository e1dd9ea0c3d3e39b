#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_scan.hpp"
#include "core/uneven_fan.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// Whether noise came in a burst in a scan: many more returns all over the fan than in others.
struct Burst {
  double probability = 0.0;  ///< That it is a burst, so that it tells nothing of what is usual.
  double excess = 0.0;       ///< By how much its background returns more than usual [usual rate], >= 0.
};

/// What is known of the error of a scan's heading, beyond that such errors happen.
struct HeadingError {
  double mean = 0.0;   ///< True heading minus the stated one [rad].
  double sigma = 0.0;  ///< Standard deviation of the rest [rad], >= 0.
};

/// One scan laid out for the likelihood: where the sonar was and, beam by beam, what it returned. Arrays over
/// beams have one slot more at either end (slot = beam + 1): outside the sector nothing is learnt; where the
/// sector is the whole circle, the slots repeat the beams across the seam.
struct ScanTable {
  std::int64_t utime = 0;     ///< Scenario time of the scan [us].
  int sensor = 0;             ///< Number of the sonar that made it, >= 0: each has figures of its own.
  core::Pose2 T_earth_sonar;  ///< As stated, but for the mean of `heading_error`.
  /// What is believed of the heading's error; nothing where it is taken for exact.
  std::optional<HeadingError> heading_error;
  double axis = 0.0;                           ///< Azimuth of the middle of the sector [rad].
  double cos_axis = 1.0, sin_axis = 0.0;       ///< Of `axis`.
  double first_bearing = 0.0;                  ///< Centre of beam 0 in the sonar frame [rad].
  double bearing_step = 0.0;                   ///< [rad]; of uneven beams the mean.
  std::shared_ptr<const core::UnevenFan> fan;  ///< Of uneven beams; null: they are even.
  double fan_middle = 0.0;                     ///< Bearing of `axis` in the sonar frame [rad].
  double max_range = 0.0;                      ///< [m].
  double cos_half_sector = 0.0;                ///< Cosine of half the sector; -1 of the whole circle.
  int num_beams = 0;                           ///< Without the two slots at the ends.
  bool whole_circle = false;                   ///< The sector closes on itself.
  ClutterModel clutter = ClutterModel::exclusive_beam;  ///< How false returns come about.
  std::vector<core::Detection> detections;              ///< The valid returns, placed in the earth frame.

  /// Likelihood ratio of a slot: base + gain exp(-(r - range)^2 / (2 sigma^2)). A silent slot has its range
  /// far away.
  std::vector<float> range;
  std::vector<float> base;  ///< Likelihood ratio of a slot far from its return, 0 to 1.
  /// What the base gains, times the probability that range takes the echo, or noise takes the target's return
  /// out of the range gate.
  std::vector<float> lost;
  /// Probability that range alone takes an echo, by the square of range [1/m^2]; see SensorFigures.
  float range_loss = 0.0F;
  bool range_gate = true;  ///< Noise takes returns out of the gate.
  /// Height of a wider peak about the return, of `tail_scale` times the width, as `gain`.
  float tail_gain = 0.0F;
  float gain = 0.0F;  ///< Height of the return's peak above `base`, where clutter is uniform.
  /// Of each slot's return (point: of each detection): the uniform background's share of the density of false
  /// returns there, in (0, 1]. 1 where clutter is uniform.
  std::vector<float> background;
  /// Laid out likewise: density of its intensity among the returns of targets over that among false ones, >
  /// 0; 1 where it tells nothing;
  std::vector<float> loudness;
  /// and what the peak's height is of `gain`: both factors and `usual` multiplied.
  std::vector<float> worth;
  /// Of each slot's return: which group of returns that one echo may have made it is in, -1 for none,
  std::vector<std::int16_t> group;
  /// and the probability that it came by itself or is the echo's own; gain and background count by it.
  std::vector<float> share;
  /// Beams from the slot's return to the mean bearing of the echo that its group is; 0 where it is none.
  std::vector<float> echo_offset;
  /// Probability that the sonar listened, see EmptyScans: by the rest, silence says nothing.
  float listened = 1.0F;
  float burst = 0.0F;  ///< See Burst::probability,
  /// and the usual share of its background, in (0, 1]: `worth` counts by it.
  float usual = 1.0F;
  float inverse_sigma = 0.0F;  ///< [1/m].
  /// point alone: bearing of each detection from `axis` [rad].
  std::vector<float> bearing_from_axis;
  float inverse_bearing_sigma = 0.0F;  ///< [1/rad].
  float inverse_resolution = 0.0F;     ///< point alone [1/m]; 0: every target has its own return.
  float half_sector = 0.0F;            ///< Beyond it from `axis` nothing is seen [rad].

  /// What the errors of the pose do to beams; see blurred_likelihood.hpp.
  int blur_reach = 0;          ///< Beams to either side of the stated one that a target may be in; 0: exact.
  float blur_heading = 0.0F;   ///< Standard deviation by the heading [beams].
  float blur_position = 0.0F;  ///< By the position, times the range [beams x m].

  /// Whether the beam returned nothing; 0 <= beam < num_beams.
  bool silent(int beam) const { return range[static_cast<std::size_t>(beam) + 1] < 0.0F; }
  /// Whether beams are uneven: what is said of them in mean spacings then goes through `fan`.
  bool uneven() const { return fan != nullptr && clutter != ClutterModel::point; }
  /// Of a bearing from `axis` [rad] (from_axis), in beams from the middle of the sector.
  double beams_from_middle(double from_axis) const {
    return uneven() ? fan->place_of(from_axis + fan_middle) - 0.5 * (num_beams - 1)
                    : from_axis / bearing_step;
  }
  /// The other way: bearing from `axis` [rad].
  double bearing_of_beams(double from_middle) const {
    return uneven() ? fan->bearing_at(from_middle + 0.5 * (num_beams - 1)) - fan_middle
                    : from_middle * bearing_step;
  }
  /// Width [rad] of the beam so many beams from the middle of the sector.
  double width_at(double from_middle) const {
    return uneven() ? fan->width(static_cast<int>(from_middle + 0.5 * num_beams)) : bearing_step;
  }
  /// Between the edges of the sector [rad].
  double sector() const { return fan ? fan->sector() : num_beams * bearing_step; }
};

/// Fills `table` from a scan; its buffers are kept, so that a warm caller allocates nothing. Two returns of
/// one beam: the nearer is taken.
/// @return how many returns were left out as impossible.
int fill_scan_table(const core::PosedScan& scan, ScanTable& table);

/// Where a scan keeps the return of a detection: of a sensor without beams its index. None for what is in no
/// beam, or behind a nearer return of its beam. @param index of the detection.
std::optional<std::size_t> slot_of(const ScanTable& scan, std::size_t index);

/// Writes the figures into a filled table: the likelihood ratios of a return that fits the target, of one
/// that does not, and of a silence.
void set_figures(const SensorFigures& figures, const SensorModelParams& model, ScanTable& table);

/// Probability that range takes the echo of a target at `range` [m], or noise takes its return out of the
/// gate.
double lost_of(const ScanTable& table, double inverse_sigma, double range);

/// Likelihood ratio that the return of a slot adds for a target at `range` [m].
/// @param sigma_scale factor on the sigma of its error, see Tolerance.
double peak_of(const ScanTable& table, std::size_t slot, double range, double sigma_scale = 1.0);

/// Turns a filled table with figures to the heading that is now believed, as uncertain as it is now.
void set_heading_error(const HeadingError& error, const SensorFigures& figures, ScanTable& table);

}  // namespace lookout::csht
