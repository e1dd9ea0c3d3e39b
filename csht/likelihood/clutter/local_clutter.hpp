#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/clutter_grid.hpp"
#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "csht/likelihood/clutter/clutter_map.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "csht/likelihood/spill_model.hpp"

namespace lookout::csht {

/// How a tracker on single returns learns where false ones are dense.
struct LocalClutterParams {
  SpillParams spill;     ///< How echoes heard in several beams are recognised.
  ClutterMapParams map;  ///< Where false returns are counted.
  int judge_every = 4;   ///< Scans after which all that are kept are judged anew, >= 1.
  double sure_age =
      10.0;  ///< A track surely moves whose returns span so long [range sigma / max speed], > 0,
  double sure_sigma = 1.0 / 6.0;  ///< tell its velocity so well [max speed], > 0,
  double sure_sigmas = 3.0;       ///< and put it so many standard deviations off rest, > 0.
  double creep = 0.003;           ///< What stands may seem to creep, see MoverParams [max speed], > 0.
  /// A return counts in full where the background makes at least this share of what returns there, in (0, 1),
  /// and by the background's share where that is below its square: chance makes places denser in a uniform
  /// sea, too.
  double clear = 0.25;
  /// Nor do gates and counts of hits take anything from a return that tells so much of a target even there
  /// [nats], > 0: where false returns are few, a place is soon many times as dense, and still next to empty.
  double enough_nats = 2.0;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const LocalClutterParams& params);

/// What a return is worth where false ones are as dense as they are.
struct ReturnWorth {
  /// The uniform background's share of the density of false returns there, in (0, 1]; 1 where it is `clear`.
  double background = 1.0;
  double weight = 1.0;   ///< Evidence for a target over that of a return in the background, in [0, 1].
  double penalty = 0.0;  ///< What the density adds to its squared distance from a prediction, >= 0.
};

/// Which track took a return.
struct Taker {
  std::int64_t track = 0;  ///< 0: none.
  bool confirmed = false;  ///< Whether the track is.
};

/// The clutter map of a tracker that has no likelihood of whole scans: from the stream and from what its
/// tracks take it learns where false returns are dense, and says what each return is worth. One map a sonar.
/// docs/clutter_map.md.
class LocalClutter {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  LocalClutter(const LocalClutterParams& params, const core::SonarParams& sonar);

  /// Takes the next scan, later than all before it, and prices its returns.
  void take(const core::PosedScan& scan);
  /// The returns of that scan as detections, in its order; of those that are one echo the likeliest, at the
  /// mean bearing of all. Without a map all of them.
  std::span<const core::Detection> detections() const { return detections_; }
  std::span<const ReturnWorth> worth() const { return worth_; }  ///< Of each of `detections()`.
  /// What is believed now of the returns of the scan `age` scans before it, where it is still kept:
  /// ReturnWorth::background of each, in the order in which `detections` had them; else empty.
  std::span<const double> backgrounds(int age) const;

  /// Ends the scan: its returns are counted, but for those of tracks. @param takers of each of
  /// `detections()`.
  void learn(std::span<const Taker> takers);

  bool enabled() const { return params_.map.enabled; }  ///< Without a map clutter counts as uniform.
  /// What the map holds, around the sonar of the newest scan; nothing without a map or a scan.
  std::optional<core::ClutterGrid> grid() const;

 private:
  struct Sensor {  // What is learnt of one sonar.
    std::int32_t id = 0;
    ClutterMap map;
    SpillModel spill;
    double rate = 0.0;       // Mean number of uniform false returns of a scan.
    std::int64_t scans = 0;  // Taken in.
  };
  struct Kept {                      // Of a scan.
    std::vector<std::size_t> index;  // Of its detections, those that are kept.
    std::vector<Taker> taker;        // Of each of these,
    std::vector<double> background;  // and likewise,
    std::vector<double> counted;     // and likewise; 1 where it is clear.
  };
  struct Course {  // Sums over the returns of a track.
    std::int64_t track = 0;
    double n = 0.0, time = 0.0, times = 0.0, first = 0.0, last = 0.0;
    Eigen::Vector2d place{0, 0}, products{0, 0};
  };

  std::size_t number_of(std::int32_t sensor_id);
  Kept& kept_at(int age);
  const Kept& kept_at(int age) const;
  void price_newest();
  void price(int age);
  void choose_echoes();
  bool leads_group(const ScanTable& scan, std::size_t slot) const;
  double information() const;
  void read_background(int age);
  void weigh();
  bool of_newest_sensor(int age) const { return scans_.at_age(age).sensor == static_cast<int>(newest_); }
  void own_echo(int age, std::size_t k);
  void discount_movers();
  void find_movers();
  void add_to_course(const Taker& taker, const core::Detection& detection, double time);
  bool surely_moves(const Course& course) const;
  double rate_of_background() const;

  LocalClutterParams params_;
  core::SonarParams sonar_;
  ScanHistory scans_;
  std::vector<Sensor> sensors_;
  std::size_t newest_ = 0;  ///< Number of the newest scan's sonar.
  std::vector<Kept> kept_;  ///< Of the scans in `scans_`, by their number modulo its capacity.
  std::vector<float> background_;
  std::vector<core::Detection> detections_;
  std::vector<ReturnWorth> worth_;
  std::vector<double> own_;
  std::vector<Course> courses_;
  std::vector<std::int64_t> movers_;
};

}  // namespace lookout::csht
