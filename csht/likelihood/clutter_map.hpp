#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/likelihood/clutter_density.hpp"
#include "csht/likelihood/dense_returns.hpp"
#include "csht/likelihood/frame_counts.hpp"
#include "csht/likelihood/look_memory.hpp"
#include "csht/likelihood/scan_table.hpp"
#include "csht/likelihood/typical_rate.hpp"

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
  /// ScanTable::background. @param rate mean number of uniform false returns of a scan, > 0.
  void price(const ScanTable& scan, double rate, std::vector<float>& background) const;

  /// Learns from the newest scan how many of the returns stand still or come from places that return more
  /// than the background, and how much more those return. @param own probability, for each detection, that a
  /// target made it. @param rate as for `price`.
  void learn(const ScanTable& newest, std::span<const double> own, double rate);
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
  void find_typical_rate(const ScanTable& scan);
  void mark_looks(const ScanTable& scan) const;
  bool counts(const BinnedPoint& p) const { return counted_[memory_.index_of(p)] != 0; }
  Excess spot_excess(const ScanTable& scan, const SeenPlace& place, double rate,
                     std::int64_t leave_out_us) const;
  struct EarthBox {  // Around a place: the line of sight, and half its length and width [m].
    Eigen::Vector2d along;
    double down = 0.0, across = 0.0;
  };
  struct EarthCounts {  // Kernels of the whole length, of a third of it, and of a third about the line of the
                        // returns.
    double wide = 0.0, thin = 0.0, line = 0.0;
  };
  template <class Use>
  void visit_earth(const SeenPlace& place, const EarthBox& box, const Use& use) const;
  EarthCounts count_in_earth(const SeenPlace& place, const EarthBox& box) const;
  Excess earth_excess(const ScanTable& scan, const SeenPlace& place, double rate) const;
  double background_at(const ScanTable& scan, const SeenPlace& place, double rate) const;
  Excess frame_excess(const ScanTable& scan, const SeenPlace& place, double rate, bool corners) const;
  ExcessPrior sonar_prior() const;
  ExcessPrior earth_prior() const;
  double clear_around(const ScanTable& scan, const SeenPlace& place, double rate) const;
  double views_of(const SeenPlace& place) const;

  ClutterMapParams params_;
  double range_reach_;  ///< [m].
  double leave_out_s_;
  std::int64_t leave_out_us_, spot_us_;
  LookMemory memory_;
  TypicalRate typical_;
  mutable std::vector<char> counted_;  ///< Of each look, whether it judges the scan at hand,
  mutable double num_counted_ = 0.0;   ///< how many do,
  mutable double num_others_ = 0.0;    ///< and how many there are beside its own.
  DenseReturns sonar_dense_, earth_dense_;
};

}  // namespace lookout::csht
