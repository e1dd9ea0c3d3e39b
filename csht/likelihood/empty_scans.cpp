#include "csht/likelihood/empty_scans.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {

double EmptyScans::take(std::size_t returns) {
  const double share = lost_share();
  const double mean = returns_ / std::max(heard_scans_, 1.0);
  const double silent = (1.0 - share) * std::exp(-mean);  // Returns are a Poisson number.
  const double listened = returns > 0 || returns_ == 0.0 ? 1.0 : silent / (silent + share);
  const double fading = 1.0 - 1.0 / kMemoryScans;
  for (double* sum : {&scans_, &lost_, &heard_scans_, &returns_}) *sum *= fading;
  scans_ += 1.0;
  lost_ += 1.0 - listened;
  heard_scans_ += listened;
  returns_ += static_cast<double>(returns);
  return listened;
}

}  // namespace lookout::csht
