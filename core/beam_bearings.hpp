#pragma once

#include <span>
#include <vector>

/// The bearings of a fan of beams, even or not: a table of the beams' centres [rad] that increases strictly
/// from port to starboard. A `place` in it counts in beams: 0 is the centre of beam 0, .5 half way to beam 1;
/// between two centres it is linear in bearing, and beyond the outer ones it goes on with their spacing.
namespace lookout::core {

/// Spacing of a table of one beam, which says nothing of its width [rad]: a degree.
inline constexpr double kSingleBeamStep = 0.017453292519943295;

/// The table of an even fan.
/// @param first_bearing of beam 0 [rad]. @param step between beams [rad], > 0. @param num_beams >= 0.
std::vector<double> even_bearings(double first_bearing, double step, int num_beams);

/// Whether the table is one: not empty, finite, strictly increasing, and at most a full turn with half a
/// spacing beyond its outer beams.
bool is_beam_table(std::span<const double> bearings);

/// Mean spacing [rad].
double mean_step(std::span<const double> bearings);

/// Spacing about a place [rad]: that of the two beams around it, or of the two outermost.
double step_at(std::span<const double> bearings, double place);

/// Bearing of a place [rad].
double bearing_at(std::span<const double> bearings, double place);

/// Place of a bearing [rad], which may be any number of turns away.
double place_of(std::span<const double> bearings, double bearing);

/// Half a spacing to port of the first beam [rad].
double left_edge(std::span<const double> bearings);
/// Half a spacing to starboard of the last beam [rad].
double right_edge(std::span<const double> bearings);

}  // namespace lookout::core
