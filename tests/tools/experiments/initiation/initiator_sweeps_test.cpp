#include "tools/experiments/initiation/initiator_sweeps.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tools {
namespace {

TEST(InitiatorCurves, AllMethodsHaveOneKOfNAndThreeDetectionProbabilities) {
  std::set<double> detections;
  for (const Cell& cell : make_initiator_curves()->cells()) {
    EXPECT_EQ(cell.parameters.number("window_scans"), 6.0);
    if (cell.method != "sequence_ht") {
      EXPECT_EQ(cell.parameters.number("min_plots"), 4.0) << cell.method;
    }
    detections.insert(cell.parameters.number("detection_probability"));
  }
  EXPECT_EQ(detections, (std::set<double>{0.7, 0.9, 1.0}));
}

/// A laxer threshold declares more; the curve of VCT ends beyond the other end in both.
TEST(InitiatorCurves, ThresholdsMove) {
  const auto experiment = make_initiator_curves();
  std::vector<double> declared;
  for (const Cell& cell : experiment->cells()) {
    if (cell.method != "vct" || cell.parameters.number("detection_probability") != 0.9) continue;
    double sum = 0.0;
    for (int run = 0; run < 20; ++run) sum += experiment->run(cell, 1000, run).at("tracks_per_run").value;
    declared.push_back(sum);
  }
  ASSERT_EQ(declared.size(), 6u);
  EXPECT_LT(declared.front(), declared.back());
}

/// Every method stands on every scene: seven turns, five accelerations, errors told wrong twice, clusters.
TEST(InitiatorLimits, EveryMethodOnEveryScene) {
  std::map<std::string, int> cells;
  for (const Cell& cell : make_initiator_limits()->cells()) ++cells[cell.method];
  for (const auto& method : tracking::initiator_names())
    EXPECT_EQ(cells[method], method == "vct" ? 2 * 15 : 15) << method;  // VCT with turns and without.
}

/// The curves hold all but `modified_ht`, whose K of N is fixed.
TEST(InitiatorCurves, EveryMethodHasACurve) {
  std::set<std::string> swept;
  for (const Cell& cell : make_initiator_curves()->cells()) swept.insert(cell.method);
  for (const auto& method : tracking::initiator_names())
    EXPECT_EQ(swept.count(method), method == "modified_ht" ? 0u : 1u) << method;
}

TEST(InitiatorTimes, EveryMethodIsTimedOnBothScenes) {
  std::map<std::string, int> cells;
  for (const Cell& cell : make_initiator_times()->cells()) ++cells[cell.method];
  EXPECT_EQ(cells.size(), tracking::initiator_names().size());
  for (const auto& [method, count] : cells) EXPECT_EQ(count, 6) << method;
}

}  // namespace
}  // namespace lookout::tools
