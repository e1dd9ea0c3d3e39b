// Source: the a-contrario idea of Desolneux, Moisan, Morel, "Meaningful alignments", IJCV, 2000, for chains
// of plots; docs/initiators.md.
#pragma once

#include "tracking/initiation/plots/gate_shapes.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// Log of the number of chains of clutter alone expected to fit one constant velocity at least as well as a
/// chain of `plots` plots with this chi-square, over all ways in which they can fall into `scans` scans. A
/// fit better than expected of a true chain tells nothing more.
/// @param log_false log of: plots to begin with x clutter expected in the reach of the first step x, for each
/// further plot, clutter density x sqrt(det S) of its innovation.
double log_false_chains(double log_false, double chi_square, int plots, int scans);

/// Updates a fit of few plots with what is known of speeds: a measured velocity of zero whose standard
/// deviation is the limit [m/s] along each axis.
void add_speed_prior(double max_speed, TrackFit& fit);

/// Whether the speed of a fit keeps the limits, widened by so many of its sigmas.
bool speed_allowed(const TrackFit& fit, const SpeedLimits& speeds, double margin_sigmas);

}  // namespace lookout::tracking
