#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lookout::core {

/// The beams of a sonar whose centres are not evenly spaced: a table of them as of core/beam_bearings.hpp,
/// laid out so that a bearing's place takes the same time in every fan. It never changes, so that all scans
/// of a sonar share one.
class UnevenFan {
 public:
  /// @param bearings centres of the beams [rad], increasing.
  /// @throws std::invalid_argument unless they are a table of at least two beams.
  explicit UnevenFan(std::vector<double> bearings);

  int num_beams() const { return static_cast<int>(bearings_.size()); }  ///< >= 2.
  std::span<const double> bearings() const { return bearings_; }        ///< Centres [rad], increasing.
  double centre(int beam) const { return bearings_[static_cast<std::size_t>(beam)]; }  ///< [rad].
  double mean_step() const { return mean_step_; }                                      ///< [rad].
  double left_edge() const { return left_edge_; }    ///< Half a spacing to port of beam 0 [rad].
  double right_edge() const { return right_edge_; }  ///< Half a spacing to starboard of the last beam [rad].
  double sector() const { return right_edge_ - left_edge_; }  ///< Between the edges [rad], at most a turn.
  double narrowest() const { return narrowest_; }             ///< Width of the narrowest beam [rad].

  /// Width of a beam [rad], from midway to its neighbours; of a number beyond the fan that of the outer beam.
  double width(int beam) const;

  /// Place of a bearing [rad], which may be any number of turns away: 0 is the centre of beam 0, .5 the edge
  /// between the beams 0 and 1; beyond the outer centres the outer spacings go on.
  double place_of(double bearing) const;
  /// The other way: bearing of a place [rad].
  double bearing_at(double place) const;

  /// The beam that a bearing lies in, that of the nearest centre; -1 outside the edges.
  int beam_of(double bearing) const;

  /// Whether a description of a fan by its mean is one of this fan: as many beams, and the outer ones within
  /// half a mean spacing.
  /// @param first_bearing [rad]. @param bearing_step [rad].
  bool fits(int num_beams, double first_bearing, double bearing_step) const;

 private:
  void sort_into_bins();

  std::vector<double> bearings_, widths_;
  std::vector<std::int32_t> bins_;  ///< Of even bearings: the last centre at or to port of each bin's start.
  double mean_step_ = 0.0, left_edge_ = 0.0, right_edge_ = 0.0, narrowest_ = 0.0;
  double bins_per_radian_ = 0.0;
};

/// Whether both say the same, bit by bit; none is an even fan.
bool same_fan(const UnevenFan* a, const UnevenFan* b);

}  // namespace lookout::core
