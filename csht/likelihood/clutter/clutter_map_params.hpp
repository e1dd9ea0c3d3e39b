#pragma once

#include "csht/likelihood/clutter/clutter_density.hpp"
#include "csht/likelihood/clutter/dense_returns.hpp"

namespace lookout::csht {

/// How false returns are counted where they come. Lengths are in units of the sensor's range error and beam
/// spacing, times in units of range error over the fastest target's speed, so that one set serves any sensor.
struct ClutterMapParams {
  bool enabled = true;        ///< Without it clutter counts as uniform.
  int memory_looks = 60;      ///< Scans that are counted, 2 to 1000.
  double memory_time = 30.0;  ///< Their least span [range sigma / max speed], > 0: scans that come faster are
                              ///< thinned out.
  /// A scan is not judged by others so near in time [range sigma / max speed], > 0, nor by so few scans, >=
  /// 0: a target is in them that no track has found yet.
  double leave_out_time = 4.0, leave_out_scans = 8.0;
  /// In the sonar's frame what comes from a place itself judges it only from so many times as far in time, >=
  /// 1: a target may move along with the sonar. What comes from around it needs no such time.
  double spot_times = 5.0;
  double range_reach = 4.0 / 3.0;  ///< Half width of the kernel along the line of sight [range sigmas], > 0.
  double sonar_beams = 3.0;        ///< And across it, in the sonar's frame [beams], > 0.
  double earth_beams = 1.5;        ///< Likewise in the earth's frame, > 0.
  ExcessPrior sonar_prior{
      .share = 0.02,
      .shape = 2.0,
      .mean = 1.0};         ///< Of places in the sonar's frame, before any return; its mean is learnt,
  double most_dense = 0.2;  ///< and its share, up to this, < 1: above, the background is taken for dense.
  DenseReturnsParams sonar_learning;  ///< How.
  double earth_shape = 0.5;           ///< Of places in the earth's frame, as ExcessPrior::shape, > 0.
  /// Their share is this, > 0, and grows by `share_growth` times the share of returns from what stands, up to
  /// `most_share`, < 1.
  double least_share = 0.02, share_growth = 1.5, most_share = 0.4;
  double standing_share = 0.1;  ///< Share of the returns that come from what stands, before any, in (0, 1).
  DenseReturnsParams earth_learning{.memory_scans = 40.0, .prior_returns = 200.0};  ///< How it is learnt.
  int most_returns = 512;  ///< Of a scan that are counted, >= 16; of more, evenly spaced ones.
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const ClutterMapParams& params);

}  // namespace lookout::csht
