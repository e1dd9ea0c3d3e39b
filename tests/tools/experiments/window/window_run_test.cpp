#include "tools/experiments/window/window_run.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

core::SonarParams sonar() {
  return load_variant("window_table2.yaml", {}).platforms.front().sonar.params;
}

// One target in view and no element: the cut-off of 20 in both units, and the count is wrong.
TEST(WindowRun, NothingFoundIsTheCutOff) {
  std::vector<TimedScan> scans(1);
  scans[0].truth.targets.resize(1);
  scans[0].truth.targets[0].visible = true;
  const Metrics metrics = score_window(scans, sonar(), {});
  EXPECT_EQ(metrics.at("position_ospa").value, 20.0);
  EXPECT_EQ(metrics.at("velocity_ospa").value, 20.0);
  EXPECT_EQ(metrics.at("count_correct").value, 0.0);
  EXPECT_FALSE(metrics.contains("velocity_ospa_count_right"));
}

// An element 3 m north and 4 m east of the target, its velocity right.
TEST(WindowRun, AnElementIsAsFarAsItLies) {
  std::vector<TimedScan> scans(1);
  scans[0].truth.targets.resize(1);
  scans[0].truth.targets[0].visible = true;
  WindowAnswer answer;
  answer.elements.resize(1);
  answer.elements[0].position = {3.0, 4.0};
  answer.elements[0].covariance.setIdentity();
  const Metrics metrics = score_window(scans, sonar(), answer);
  EXPECT_DOUBLE_EQ(metrics.at("position_ospa").value, 5.0);
  EXPECT_EQ(metrics.at("velocity_ospa").value, 0.0);
  EXPECT_EQ(metrics.at("count_correct").value, 1.0);
}

/// Returns an element at each scan, as many as it has seen scans.
class CountingEstimator : public csht::MotionEstimator {
 public:
  std::span<const core::MotionElement> update(const core::PosedScan&) override {
    elements_.emplace_back();
    return elements_;
  }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::other; }
  int window_scans() const override { return 3; }

 private:
  std::vector<core::MotionElement> elements_;
};

TEST(WindowRun, TheAnswerIsThatToTheNewestScan) {
  CountingEstimator estimator;
  EXPECT_EQ(estimate_window(estimator, std::vector<TimedScan>(3)).elements.size(), 3U);
}

}  // namespace
}  // namespace lookout::tools
