#include "tracking/estimating_tracker.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Reports one track whose id is the scan's sequence.
class EchoTracker : public Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan& scan) override {
    track_.id = scan.scan.sequence;
    return {&track_, 1};
  }
  std::optional<core::SensorEstimate> sensor_estimate() const override { return core::SensorEstimate{}; }

 private:
  core::Track track_;
};

/// Reports one element whose support is the scan's sequence.
class EchoEstimator : public csht::MotionEstimator {
 public:
  std::span<const core::MotionElement> update(const core::PosedScan& scan) override {
    element_.support = static_cast<int>(scan.scan.sequence);
    return {&element_, 1};
  }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::sht; }
  int window_scans() const override { return 1; }

 private:
  core::MotionElement element_;
};

TEST(EstimatingTracker, TracksAndElementsOfTheSameScan) {
  EstimatingTracker tracker(std::make_unique<EchoTracker>(), std::make_unique<EchoEstimator>());
  EXPECT_TRUE(tracker.elements().empty());
  core::PosedScan scan;
  for (const std::int64_t sequence : {4, 5}) {
    scan.scan.sequence = sequence;
    EXPECT_EQ(tracker.update(scan).front().id, sequence);
    EXPECT_EQ(tracker.elements().front().support, sequence);
  }
  EXPECT_TRUE(tracker.sensor_estimate());
}

}  // namespace
}  // namespace lookout::tracking
