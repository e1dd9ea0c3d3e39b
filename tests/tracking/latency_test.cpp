#include "tracking/latency.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// One track and one element at the origin, 2 m/s to the north; the track's id is the time that it was asked
/// for [s].
class OneTarget : public Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan& scan) override { return at(scan.scan.utime); }
  std::span<const core::MotionElement> elements() const override { return {&element_, 1}; }
  void explain_to(DecisionLog log) override { log({.utime = 5 * kSecond}); }
  bool can_retrodict() const override { return true; }
  std::span<const core::Track> retrodict(std::int64_t utime) override { return at(utime); }

 private:
  std::span<const core::Track> at(std::int64_t utime) {
    track_.id = utime / kSecond;
    track_.state = {0.0, 0.0, 2.0, 0.0};
    track_.covariance = Eigen::Vector4d(1.0, 1.0, 0.25, 0.25).asDiagonal();
    element_.velocity = {2.0, 0.0};
    return {&track_, 1};
  }

  core::Track track_;
  core::MotionElement element_;
};

core::PosedScan scan_at(std::int64_t utime) {
  core::PosedScan posed;
  posed.scan.utime = utime;
  return posed;
}

LateScanTracker three_seconds_late() {
  return {std::make_unique<OneTarget>(), 3 * kSecond};
}

TEST(LateScanTracker, WorksAtTheTimeOfTheReturnsAndAnswersAtTheScans) {
  LateScanTracker tracker = three_seconds_late();
  const auto tracks = tracker.update(scan_at(10 * kSecond));
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 7);
  EXPECT_DOUBLE_EQ(tracks[0].state[0], 6.0);           // 3 s at 2 m/s
  EXPECT_DOUBLE_EQ(tracks[0].covariance(0, 0), 3.25);  // 1 + 3^2 x 0.25
  EXPECT_DOUBLE_EQ(tracks[0].covariance(0, 2), 0.75);  // 3 x 0.25
  EXPECT_DOUBLE_EQ(tracker.elements()[0].position.x(), 6.0);
}

TEST(LateScanTracker, ThePastIsThatOfTheTrackerWithin) {
  LateScanTracker tracker = three_seconds_late();
  tracker.update(scan_at(10 * kSecond));
  EXPECT_EQ(tracker.retrodict(6 * kSecond)[0].id, 6);
  EXPECT_DOUBLE_EQ(tracker.retrodict(6 * kSecond)[0].state[0], 0.0);
  // Nothing is known beyond 7 s: from there on tracks keep their course.
  EXPECT_EQ(tracker.retrodict(9 * kSecond)[0].id, 7);
  EXPECT_DOUBLE_EQ(tracker.retrodict(9 * kSecond)[0].state[0], 4.0);
}

TEST(LateScanTracker, DecisionsAreOfTheScansTime) {
  LateScanTracker tracker = three_seconds_late();
  std::int64_t utime = 0;
  tracker.explain_to([&utime](const TrackDecision& decision) { utime = decision.utime; });
  EXPECT_EQ(utime, 8 * kSecond);
}

TEST(LateScanTracker, ASensorWithoutLatencyNeedsNone) {
  auto tracker = std::make_unique<OneTarget>();
  const Tracker* const plain = tracker.get();
  EXPECT_EQ(make_up_for_latency(std::move(tracker), {}).get(), plain);
  core::SonarParams late;
  late.latency = 3.0;
  const auto made_up = make_up_for_latency(std::make_unique<OneTarget>(), late);
  EXPECT_EQ(made_up->update(scan_at(10 * kSecond))[0].id, 7);
}

}  // namespace
}  // namespace lookout::tracking
