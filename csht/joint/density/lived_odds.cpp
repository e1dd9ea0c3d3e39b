#include "csht/joint/density/lived_odds.hpp"

#include <cmath>

namespace lookout::csht {
namespace {

// Odds of a target that has survived with this probability: ln(s p / (1 - s p)), finite however sure either
// way.
double survived(double odds, double survival) {
  if (survival >= 1.0) return odds;
  if (odds > 0.0) return std::log(survival) - std::log(std::exp(-odds) + (1.0 - survival));
  return odds + std::log(survival) - std::log1p(std::exp(odds) * (1.0 - survival));
}

}  // namespace

double lived_odds(double before, std::span<const double> gains, std::span<const double> survival) {
  double odds = before;
  for (std::size_t age = gains.size(); age-- > 0;) {
    if (age + 1 < gains.size()) odds = survived(odds, survival[age]);
    odds += gains[age];
  }
  return odds;
}

}  // namespace lookout::csht
