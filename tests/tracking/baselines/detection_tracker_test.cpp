#include "tracking/baselines/detection_tracker.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr TrackLifeParams kLife{
    .confirm_hits = 3, .confirm_scans = 3, .max_misses = 2.0, .first_misses = 2.0, .misses_per_hit = 0.0};

/// Each track takes the detection of its own place in the list.
class OneByOne : public DetectionTracker {
 public:
  explicit OneByOne(std::unique_ptr<BirthMethod> births = nullptr)
      : DetectionTracker(kLife, {}, {}, std::move(births)) {}

 private:
  void take(const core::PosedScan& scan, const core::SonarParams& /*sonar*/) override {
    book_.predict_to(scan.scan.utime, {});
    for (std::size_t i = 0; i < std::min(book_.tracks().size(), detections().size()); ++i) give(i, i);
  }
  void begin_on(const core::Detection& detection, const core::SonarParams& /*sonar*/,
                double support) override {
    book_.begin(detection.utime, {detection.p_earth.x(), detection.p_earth.y(), 0.0, 0.0},
                Eigen::Matrix4d::Identity(), kFreeDetection, support);
  }
};

/// Proposes nothing, ever.
class Barren : public BirthMethod {
 public:
  std::span<const core::MotionElement> propose(const core::PosedScan& /*scan*/,
                                               std::span<const core::Track> /*tracks*/) override {
    return {};
  }
};

TEST(DetectionTracker, BeginsOnWhatNoTrackTook) {
  OneByOne tracker;
  EXPECT_EQ(tracker.update(scan_of(0, {{50.0, 0.0}}), {}).size(), 1U);
  EXPECT_EQ(tracker.update(scan_of(1, {{50.0, 0.0}, {80.0, 0.0}}), {}).size(), 2U);
  EXPECT_EQ(tracker.next_id(), 3);
}

TEST(DetectionTracker, ATentativeTrackExistsByItsShareOfM) {
  OneByOne tracker;
  EXPECT_DOUBLE_EQ(tracker.update(scan_of(0, {{50.0, 0.0}}), {})[0].existence,
                   0.5 * 1.0 / 4.0);  // 1 of M + 1
  EXPECT_DOUBLE_EQ(tracker.update(scan_of(1, {{50.0, 0.0}}), {})[0].existence, 0.5 * 2.0 / 4.0);
  EXPECT_EQ(tracker.update(scan_of(2, {{50.0, 0.0}}), {})[0].existence, 1.0);
}

TEST(DetectionTracker, WithABirthMethodFreeDetectionsBeginNothing) {
  OneByOne tracker(std::make_unique<Barren>());
  EXPECT_TRUE(tracker.update(scan_of(0, {{50.0, 0.0}}), {}).empty());
}

TEST(DetectionTracker, TellsWhatItsBookDecides) {
  OneByOne tracker;
  ASSERT_TRUE(tracker.explains());
  std::string told;
  tracker.explain_to(
      [&told](const TrackDecision& decision) { told += std::string(to_string(decision.kind)) + " "; });
  for (int k = 0; k < 3; ++k) tracker.update(scan_of(k, {{50.0, 0.0}}), {});
  for (int k = 3; k < 6; ++k) tracker.update(scan_of(k, {}), {});
  EXPECT_EQ(told, "begin confirm end ");
}

}  // namespace
}  // namespace lookout::tracking
