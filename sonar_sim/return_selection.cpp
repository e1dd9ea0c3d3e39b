#include "sonar_sim/return_selection.hpp"

#include <algorithm>
#include <tuple>

namespace lookout::sonar_sim {
namespace {

/// What decides within a beam: the smaller rank goes first.
double rank(const BeamReturn& heard, Keep keep) {
  switch (keep) {
    case Keep::precedence:
      return static_cast<double>(heard.source);
    case Keep::strongest:
      return -heard.measured.intensity;
    case Keep::nearest:
      break;
  }
  return 0.0;
}

}  // namespace

std::vector<BeamReturn> select_returns(std::vector<BeamReturn> heard, int returns_per_beam, Keep keep) {
  const auto key = [keep](const BeamReturn& one) {
    return std::make_tuple(one.beam, rank(one, keep), one.measured.range);
  };
  std::sort(heard.begin(), heard.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<BeamReturn> kept;
  int beam = -1, in_beam = 0;
  for (const auto& one : heard) {
    in_beam = one.beam == beam ? in_beam + 1 : 1;
    beam = one.beam;
    if (in_beam <= returns_per_beam) kept.push_back(one);
  }
  return kept;
}

std::vector<core::SonarReturn> in_order(const std::vector<BeamReturn>& heard) {
  std::vector<core::SonarReturn> returns;
  for (const auto& one : heard) returns.push_back(one.measured);
  std::sort(returns.begin(), returns.end(), [](const auto& a, const auto& b) {
    return std::tie(a.bearing, a.range) < std::tie(b.bearing, b.range);
  });
  return returns;
}

}  // namespace lookout::sonar_sim
