#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/likelihood/clutter/clutter_map_params.hpp"
#include "csht/likelihood/clutter/dense_returns.hpp"
#include "csht/likelihood/clutter/earth_frame.hpp"
#include "csht/likelihood/clutter/look_memory.hpp"
#include "csht/likelihood/clutter/look_times.hpp"
#include "csht/likelihood/clutter/sonar_frame.hpp"
#include "csht/likelihood/clutter/typical_rate.hpp"
#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// Where false returns come more densely than the uniform background: in the sonar's frame (a noisy beam, the
/// bottom, scatter that moves along) and in the earth's (rocks, walls). The map is the latest scans
/// themselves: a place's density is the number of returns around it in all scans but those near in time, in
/// which a moving target would still be there. docs/clutter_map.md.
class ClutterMap {
 public:
  /// @param params validated.
  ClutterMap(const ClutterMapParams& params, const core::SonarParams& sonar);

  /// Takes the newest scan in, if it is time for one. Cost: O(returns in memory).
  void add(const ScanTable& scan);
  /// Lets the returns of a past scan count less: `own[j]` is the probability that a moving target made
  /// detection j. It is believed where nothing is dense around the return: a track may follow the returns
  /// of a bottom or a wall. Nothing happens where the scan was not taken. @param rate as for `price`.
  void discount(const ScanTable& scan, std::span<const double> own, double rate);

  /// Writes the background's share of each return of `scan` to `background`, laid out as
  /// ScanTable::background, and keeps, where the scan was taken, how much of each return either frame
  /// explains. @param rate mean number of uniform false returns of a scan, > 0.
  void price(const ScanTable& scan, double rate, std::vector<float>& background);

  /// The same of one detection, also of one that the scan keeps no slot for. @param scan the last that was
  /// priced.
  double background_of(const ScanTable& scan, std::size_t detection, double rate) const {
    return background_at(scan, seen_place(scan, scan.detections[detection]), rate);
  }

  /// Learns from the newest scan how many of the returns stand still or come from places that return more
  /// than the background, and how much more those return. @param own probability, for each detection, that a
  /// target made it. @param rate as for `price`.
  void learn(const ScanTable& newest, std::span<const double> own, double rate);
  /// `rate`, or by how much of the newest scan most of the fan shows that the uniform background makes more:
  /// who learns the rate from the prices alone would see what is dense by chance make it less, and then all
  /// dense.
  double at_least_typical(double rate) const { return typical_.at_least(rate); }
  /// Probability that a return is of what stands still.
  double standing_share() const { return earth_dense_.share(); }

  /// A place around the sonar of a scan, and what is known of it.
  struct PricedPlace {
    double beam = 0.0;        ///< Beams from the axis of the scan, to starboard.
    double range = 0.0;       ///< From its sonar [m].
    double background = 1.0;  ///< The background's share of the density of false returns there.
  };
  /// Where the returns in memory lie around the sonar of `scan`: each as it was in the sonar's frame and as
  /// it was in the earth's, within the fan, priced by the scans that are not near in time to its own.
  /// @param rate as for `price`. @param most returns that are taken, > 0; of more, evenly spaced ones.
  std::vector<PricedPlace> places(const ScanTable& scan, double rate, std::size_t most) const;

 private:
  // What is dense at a place in either frame.
  struct PlaceExcess {
    TwoExcesses sonar, earth;
    double density() const;
    double explained_by_sonar() const;
    double explained_by_earth() const;
  };
  void find_typical_rate(const ScanTable& scan);
  PlaceExcess excess_at(const ScanTable& scan, const SeenPlace& place, double rate) const;
  double background_at(const ScanTable& scan, const SeenPlace& place, double rate) const;
  ExcessPrior sonar_prior() const;
  ExcessPrior earth_prior() const;
  double clear_around(const ScanTable& scan, const SeenPlace& place, double rate) const;

  ClutterMapParams params_;
  double range_reach_;  ///< [m].
  std::int64_t leave_out_us_;
  LookMemory memory_;
  TypicalRate typical_;
  mutable LookTimes times_;  ///< Of the scan at hand.
  SonarFrame sonar_;
  EarthFrame earth_;
  DenseReturns sonar_dense_, earth_dense_;
};

}  // namespace lookout::csht
