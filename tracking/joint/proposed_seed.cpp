#include "tracking/joint/proposed_seed.hpp"

namespace lookout::tracking {

csht::BirthSeed seed_of(const core::MotionElement& element, const csht::ScanHistory& scans) {
  csht::BirthSeed seed;
  seed.guess.mean.head<4>() = element.state();
  seed.guess.covariance.topLeftCorner<4, 4>() = element.covariance;
  for (int age = 0; age < scans.size() && scans.at_age(age).utime >= element.initial_utime; ++age)
    seed.start_age = age;
  return seed;
}

}  // namespace lookout::tracking
