#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "csht/likelihood/clutter/look_memory.hpp"
#include "csht/likelihood/clutter/look_times.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {

/// Sixty looks, half a second apart, of a sonar at rest: 90 beams, of which those that nothing else is heard
/// in alarm with P_F = .1. The times are those of the last look.
struct WatchedLooks {
  static constexpr int kLooks = 60;
  static constexpr double kFalseAlarm = 0.1;
  /// Range of a beam's return [m]; nothing where it has none but false alarms.
  using Thing = std::function<std::optional<double>(int beam, core::Random& random)>;

  explicit WatchedLooks(const Thing& thing) {
    core::Random random(7);
    for (int k = 0; k < kLooks; ++k) take(thing, k, random);
    times.mark(memory, history.newest().utime);
  }

  /// Bearing of the middle of a beam [rad].
  static double bearing(int beam) { return core::radians(-44.5 + beam); }
  /// A place in the middle of a beam. @param range [m].
  SeenPlace place(int beam, double range) const {
    return seen_place(history.newest(), core::from_polar(range, bearing(beam)));
  }

  ScanHistory history{{}, {}, 1};
  LookMemory memory{{.most_looks = kLooks, .most_returns = 512, .range_reach = 4.0}};
  LookTimes times{4'000'000, 20'000'000};

 private:
  void take(const Thing& thing, int look, core::Random& random) {
    std::vector<core::SonarReturn> returns;
    for (int beam = 0; beam < 90; ++beam) {
      if (const auto range = thing(beam, random))
        returns.push_back({bearing(beam), *range, 1.0});
      else if (random.bernoulli(kFalseAlarm))
        returns.push_back({bearing(beam), random.uniform(0.1, 150.0), 1.0});
    }
    history.push(posed_scan(returns, 500'000L * look));
    memory.add(history.newest());
  }
};

}  // namespace lookout::csht
