#include "tracking/intake/crowded_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMost = 512.0, kFewest = 256.0;
/// Returns in memory at the period of a sensor, of a minute [1/s]: some 30 MB.
constexpr double kReturnsPerSecond = 6'666.0;

/// Spreads neighbours over all numbers (Fibonacci hashing).
std::uint32_t scattered(int beam) {
  return static_cast<std::uint32_t>(beam) * 2'654'435'769U;
}

struct Ranked {
  int beam = 0;
  int turn = 0;  ///< In which its beam gives it.
  std::size_t index = 0;
};

/// The returns of a scan, beam by beam, each beam's in the order in which it gives them.
std::vector<Ranked> by_beam(const core::SonarScan& scan) {
  std::vector<Ranked> ranked(scan.returns.size());
  for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i] = {beam_of(scan, scan.returns[i].bearing), 0, i};
  const auto key = [&scan](const Ranked& one) {
    const core::SonarReturn& it = scan.returns[one.index];
    return std::make_tuple(one.beam, -it.intensity, it.range, one.index);
  };
  std::sort(ranked.begin(), ranked.end(),
            [&key](const Ranked& a, const Ranked& b) { return key(a) < key(b); });
  for (std::size_t k = 1; k < ranked.size(); ++k)
    if (ranked[k].beam == ranked[k - 1].beam) ranked[k].turn = ranked[k - 1].turn + 1;
  return ranked;
}

}  // namespace

std::size_t most_returns(double period) {
  return static_cast<std::size_t>(std::clamp(kReturnsPerSecond * period, kFewest, kMost));
}

std::int64_t thin_out(core::SonarScan& scan, std::size_t most) {
  if (scan.returns.size() <= most) return 0;
  std::vector<Ranked> ranked = by_beam(scan);
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return std::make_tuple(a.turn, scattered(a.beam)) < std::make_tuple(b.turn, scattered(b.beam));
  });
  const auto left_out = static_cast<std::int64_t>(ranked.size() - most);
  ranked.resize(most);
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.index < b.index; });
  for (std::size_t k = 0; k < most; ++k) scan.returns[k] = scan.returns[ranked[k].index];
  scan.returns.resize(most);
  return left_out;
}

std::int64_t thin_out(core::SonarImage& /*image*/, std::size_t /*most*/) {
  return 0;
}

std::int64_t returns_behind(const core::SonarScan& scan, std::vector<char>& heard) {
  heard.assign(static_cast<std::size_t>(scan.num_beams), 0);
  std::int64_t behind = 0;
  for (const core::SonarReturn& one : scan.returns) {
    const int beam = beam_of(scan, one.bearing);
    if (beam < 0 || beam >= scan.num_beams) continue;
    behind += heard[static_cast<std::size_t>(beam)];
    heard[static_cast<std::size_t>(beam)] = 1;
  }
  return behind;
}

std::int64_t returns_behind(const core::SonarImage& /*image*/, std::vector<char>& /*heard*/) {
  return 0;
}

}  // namespace lookout::tracking
