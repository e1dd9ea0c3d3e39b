#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "csht/joint/clutter_learning.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/density/wander.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/joint/evidence/trajectory_sampler.hpp"
#include "csht/joint/evidence/undetected_targets.hpp"
#include "csht/joint/sensor_learning.hpp"
#include "csht/joint/sensor_looks.hpp"

namespace lookout::csht {

/// Where the random draws of an engine come from: those of a scan derive from (seed, stream, scan sequence)
/// alone.
struct DrawSource {
  std::uint64_t seed = 1;                                   ///< Of the run.
  core::RandomStream stream = core::RandomStream::tracker;  ///< Keeps the draws of its users apart.
};

/// What the joint engine knows: the latest scans with what explains them, the hypotheses of targets, and the
/// tools to sample them. One table of scans, one set of claims, one sampler for estimator and tracker.
class JointScene {
 public:
  /// @param params validated.
  JointScene(const JointEngineParams& params, const core::SonarParams& sonar, const DrawSource& source);

  TargetPrior prior;                ///< What is believed of targets before anything is seen.
  core::Random random;              ///< Seeded anew by every scan.
  Wander wander;                    ///< How targets stray.
  ScanLikelihood likelihood;        ///< The scans in memory, and who claims what of them.
  TrajectorySampler sampler;        ///< Draws densities of trajectories under that likelihood.
  UndetectedTargets undetected;     ///< How many targets no track stands for.
  ClutterLearning clutter;          ///< Where false returns are dense, from the same scans.
  TrajectoryCloud fresh;            ///< Where a cloud is drawn before it replaces another.
  std::vector<TargetTrack> tracks;  ///< Slots, used again when free.
  /// Asked between the pieces of a scan's work: true once the scan is given up, and the rest may be left.
  std::function<bool()> stopped = [] { return false; };

  /// Takes the next scan, later than all before it. @return seconds since the one before; 0 for the first.
  double take(const core::PosedScan& scan);

  /// What is learnt of the figures of the newest scan's sonar, from the same scans.
  const SensorLearning& learning() const { return learnings_[newest_sensor_]; }
  SensorLearning& learning() { return learnings_[newest_sensor_]; }  ///< The same.
  const SensorLooks& looks() const { return looks_; }  ///< Which sonars look, and when each did last.

  void learn();  ///< The sensor's figures and the density of false returns, from the newest scan.

  const ScanHistory& scans() const { return likelihood.scans(); }  ///< Those in memory.
  std::int64_t now() const { return scans().newest().utime; }      ///< Time of the newest scan [us].

  /// A slot that is free, with a new identity; null when `max_tracks` are alive. The caller fills it and sets
  /// `used`.
  TargetTrack* free_track();
  /// Index in `tracks` of one of them.
  int slot_of(const TargetTrack& track) const { return static_cast<int>(&track - tracks.data()); }
  void release(TargetTrack& track);  ///< Frees the slot and takes back what it claimed.

  std::int64_t next_id() const { return last_id_ + 1; }     ///< Of the next track.
  void set_next_id(std::int64_t id) { last_id_ = id - 1; }  ///< Identities go on from there.
  void set_expected_targets(double expected);               ///< In the field of view, > 0, as it is learnt.

 private:
  void push(const core::PosedScan& scan);

  DrawSource source_;
  core::SonarParams sonar_;
  SensorLearningParams learning_;
  std::vector<SensorLearning> learnings_;  ///< By sonar.
  std::size_t newest_sensor_ = 0;
  SensorLooks looks_;
  bool looks_anew_;  ///< A window of given length: its targets count as undetected when it begins.
  std::size_t max_tracks_;
  std::int64_t last_id_ = 0;
};

}  // namespace lookout::csht
