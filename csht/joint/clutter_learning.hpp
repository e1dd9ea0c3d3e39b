#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/clutter_grid.hpp"
#include "core/sonar_params.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/likelihood/clutter/clutter_map.hpp"
#include "csht/likelihood/intensity_law.hpp"

namespace lookout::csht {

/// Keeps the density of false returns and the law of intensities, and with them the likelihood of all scans
/// in memory: prices each new scan, counts its returns but for those of sure, moving targets, and lets the
/// odds of the tracks follow when the past is judged anew. docs/clutter_map.md.
class ClutterLearning {
 public:
  /// @param params validated.
  ClutterLearning(const ClutterLearningParams& params, const core::SonarParams& sonar);

  /// Sets the background's share of the newest scan's returns, before tracks take it in.
  void price_newest(ScanLikelihood& likelihood);

  /// A target vanishes in view after this time on average [s], > 0; infinity until it is told. What odds
  /// once gained is forgotten with it.
  void set_mean_life(double seconds) { mean_life_s_ = seconds; }

  /// Takes the newest scan into the map, after the tracks have. Now and then judges all scans anew and lets
  /// weights and odds of the tracks, which stand at the newest scan, follow what that changes.
  /// @param stopped asked between tracks; once it is true the rest is left undone.
  void learn(
      std::span<TargetTrack> tracks, ScanLikelihood& likelihood,
      const std::function<bool()>& stopped = [] { return false; });

  /// What the map holds, around the sonar of the newest scan; nothing without a map or a scan.
  std::optional<core::ClutterGrid> grid(const ScanLikelihood& likelihood) const;

  double standing_share() const { return sensors_[newest_].map.standing_share(); }  ///< See ClutterMap.

 private:
  struct Sensor {  // What is learnt of one sonar.
    ClutterMap map;
    SpillModel spill;
    IntensityLaw intensity;
    std::int64_t scans = 0;  // Taken in.
  };

  struct Prices {  // Of the returns of a scan, laid out as those of ScanTable.
    std::vector<float> background, loudness;
  };

  Sensor blank_sensor() const;
  Sensor& sensor_of(const ScanTable& newest);
  void group(int age, ScanLikelihood& likelihood);
  void reserve(const ScanTable& scan, int scans);
  template <class Condition>
  bool mark(std::span<const TargetTrack> tracks, const Condition& holds);
  void discount_movers(std::span<const TargetTrack> tracks, const ScanLikelihood& likelihood);
  void own_returns(int age, const ScanLikelihood& likelihood);
  void learn_intensities(std::span<const TargetTrack> tracks, const ScanLikelihood& likelihood);
  bool is_no_clutter(const TargetTrack& track, std::int64_t now) const;
  void judge_anew(std::span<TargetTrack> tracks, ScanLikelihood& likelihood,
                  const std::function<bool()>& stopped);
  Prices& prices_of(int age, const ScanHistory& scans);
  void price_anew(ScanLikelihood& likelihood);
  void find_changes(const ScanHistory& scans);
  void add_gains(bool anew, TargetTrack& track, int slot, ScanLikelihood& likelihood);
  void take_change(int slot, TargetTrack& track) const;

  ClutterLearningParams params_;
  core::SonarParams sonar_;
  std::vector<Sensor> sensors_;  ///< By number.
  std::size_t newest_ = 0;       ///< Number of the newest scan's.
  double sure_age_s_, max_speed_;
  double mean_life_s_ = std::numeric_limits<double>::infinity();
  std::vector<Prices> prices_;  ///< The latest of each scan in memory,
  std::vector<int> changed_;    ///< and the ages where they differ from those that hold.
  std::vector<std::array<std::vector<double>, 2>> gains_;  ///< Of each track by age: before, and anew [nats].
  std::vector<double> survival_;                           ///< By age, from the scan before, see lived_odds.
  std::vector<double> own_, likely_, ratio_;
  std::vector<char> marked_;
};

}  // namespace lookout::csht
