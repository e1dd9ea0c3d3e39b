#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/track.hpp"
#include "tracking/baselines/gaussian/association_marginals.hpp"
#include "tracking/baselines/gaussian/existence_life.hpp"
#include "tracking/baselines/gaussian/gaussian_target.hpp"
#include "tracking/baselines/gaussian/rival_scene.hpp"

namespace lookout::tracking {

/// A target that may exist: one Bernoulli component.
struct BernoulliTrack {
  std::int64_t id = 0;                    ///< Unique within a run of the tracker.
  GaussianTarget target;                  ///< Given that it exists.
  double existence = 0.0;                 ///< Probability that it exists.
  double detected = 0.0;                  ///< Probability that it exists and was detected in the newest scan.
  BeamSpread spread;                      ///< Where the newest scan sees it.
  ExistenceLife life;                     ///< Tentative, confirmed, coasting.
  std::int64_t first_utime = 0;           ///< When it began [us].
  std::int64_t last_detection_utime = 0;  ///< When a return was more probably its own than not [us].
};

/// The track as it is reported.
core::Track to_track(const BernoulliTrack& track);

/// What the tracks say of the sensor after a scan.
ScanTally tally_of(std::span<const BernoulliTrack> tracks, const ScanView& view);

/// Takes a scan into Bernoulli components by the marginal probabilities of their joint association.
/// [Musicki2004]; as components of a Poisson multi-Bernoulli density, TOMB/P of [Williams2015].
class BernoulliUpdate {
 public:
  /// @param most_events of a cluster that are summed one by one.
  explicit BernoulliUpdate(double most_events) : marginals_(most_events) {}

  /// @param tracks at the time of the scan, with their spread.
  /// @param free of each return: probability that nothing else owns it.
  void update(std::span<BernoulliTrack> tracks, const RivalScene& scene, std::span<const double> free);

  /// After `update`: probability that a return belongs to none of the tracks.
  double unclaimed(std::size_t detection) const { return marginals_.unclaimed(static_cast<int>(detection)); }

 private:
  void weigh(std::span<const BernoulliTrack> tracks, const RivalScene& scene, std::span<const double> free);
  void settle(std::span<BernoulliTrack> tracks, const RivalScene& scene);
  std::size_t settle(std::size_t index, std::size_t pair, BernoulliTrack& track, const RivalScene& scene);

  AssociationMarginals marginals_;
  std::vector<double> missed_;  // Of each track: weight of its having no return, over not existing or not.
  std::vector<double> miss_ratio_;
  std::vector<AssociationPair> pairs_;
};

}  // namespace lookout::tracking
