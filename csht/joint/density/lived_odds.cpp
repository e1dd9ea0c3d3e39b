#include "csht/joint/density/lived_odds.hpp"

#include "csht/joint/density/target_track.hpp"

namespace lookout::csht {

double lived_odds(double before, std::span<const double> gains, std::span<const double> survival) {
  double odds = before;
  for (std::size_t age = gains.size(); age-- > 0;) {
    if (age + 1 < gains.size()) odds = log_odds(probability(odds) * survival[age]);
    odds += gains[age];
  }
  return odds;
}

}  // namespace lookout::csht
