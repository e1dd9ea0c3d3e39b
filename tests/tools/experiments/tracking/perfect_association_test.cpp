#include "tools/experiments/tracking/perfect_association.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/metrics/scorer.hpp"

namespace lookout::tools {
namespace {

std::vector<TimedScan> easy_run() {
  return simulate(load_variant("tracking_table7.yaml", {0.1, 0.1, 1.0, sonar_sim::ClutterReading::light}),
                  1000, 0);
}

TEST(PerfectAssociation, IsBetterThanATracker) {
  const auto scans = easy_run();
  const core::SonarParams sonar;
  PerfectAssociation reference(sonar);
  tracking::Scorer told, found;
  const auto tracker = pipeline_of("gnn", sonar, 1);
  for (const auto& scan : scans) {
    told.add(scan.truth, reference.update(scan));
    found.add(scan.truth, tracker->step(scan.posed).tracks);
  }
  EXPECT_LT(told.mean().position.total, found.mean().position.total);
  EXPECT_LT(told.mean().position.total, 1.0);  // sigma 1 m and the late first detection of five targets
}

TEST(PerfectAssociation, NeverReportsMoreThanIsInView) {
  PerfectAssociation reference{core::SonarParams{}};
  for (const auto& scan : easy_run()) {
    const auto in_view = std::count_if(scan.truth.targets.begin(), scan.truth.targets.end(),
                                       [](const auto& target) { return target.visible; });
    EXPECT_LE(static_cast<long>(reference.update(scan).size()), in_view);
  }
}

}  // namespace
}  // namespace lookout::tools
