#include "tracking/scan_pipeline.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// One track at the origin, 2 m/s to the north; its id is the time that it was asked for [s]. Notes what it
/// was called with.
class OneTarget : public Tracker {
 public:
  explicit OneTarget(std::string* calls = nullptr) : calls_(calls) {}
  csht::Explained take(const core::PosedScan& /*scan*/) override {
    note("take ");
    return {{&track_, 1}};
  }
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override {
    note("update with " + std::to_string(elements.size()));
    return at(scan.scan.utime);
  }
  void explain_to(const DecisionLog& log) override { log({.utime = 5 * kSecond}); }
  std::int64_t next_id() const override { return 1; }
  void set_next_id(std::int64_t /*id*/) override {}
  bool can_retrodict() const override { return true; }
  std::span<const core::Track> retrodict(std::int64_t utime) override { return at(utime); }

 private:
  void note(const std::string& call) {
    if (calls_ != nullptr) *calls_ += call;
  }
  std::span<const core::Track> at(std::int64_t utime) {
    track_.id = utime / kSecond;
    track_.state = {0.0, 0.0, 2.0, 0.0};
    track_.covariance = Eigen::Vector4d(1.0, 1.0, 0.25, 0.25).asDiagonal();
    return {&track_, 1};
  }

  std::string* calls_;
  core::Track track_;
};

/// One element at the origin, 2 m/s to the north.
class OneElement : public csht::MotionEstimator {
 public:
  explicit OneElement(std::string* calls = nullptr) : calls_(calls) { element_.velocity = {2.0, 0.0}; }
  void offer(const csht::Explained& explained) override {
    note("offer " + std::to_string(explained.tracks.size()) + " ");
  }
  std::span<const core::MotionElement> update(const core::PosedScan& /*scan*/) override {
    note("estimate ");
    return {&element_, 1};
  }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::sht; }
  int window_scans() const override { return 7; }

 private:
  void note(const std::string& call) {
    if (calls_ != nullptr) *calls_ += call;
  }

  std::string* calls_;
  core::MotionElement element_;
};

core::PosedScan scan_at(std::int64_t utime) {
  core::PosedScan posed;
  posed.scan.utime = utime;
  posed.scan.sequence = 4;
  posed.scan.sensor_id = 2;
  posed.T_earth_sonar = {5.0, 6.0, 0.0};
  return posed;
}

ScanPipeline with_latency(std::int64_t latency) {
  return {std::make_unique<OneElement>(), std::make_unique<OneTarget>(), latency};
}

TEST(ScanPipeline, OffersEstimatesAndTracksInThisOrder) {
  std::string calls;
  ScanPipeline pipeline(std::make_unique<OneElement>(&calls), std::make_unique<OneTarget>(&calls));
  pipeline.step(scan_at(0));
  EXPECT_EQ(calls, "take offer 1 estimate update with 1");
}

TEST(ScanPipeline, TellsOfThePingAndOfTheEstimatorThatRan) {
  const PingResult result = with_latency(0).step(scan_at(3 * kSecond));
  EXPECT_EQ(result.utime, 3 * kSecond);
  EXPECT_EQ(result.sequence, 4);
  EXPECT_EQ(result.sensor_id, 2);
  EXPECT_EQ(result.p_earth_sonar, Eigen::Vector2d(5.0, 6.0));
  EXPECT_EQ(result.method, core::EstimatorMethod::sht);
  EXPECT_EQ(result.window_scans, 7);
}

TEST(ScanPipeline, WithoutAnEstimatorThereAreNoElements) {
  std::string calls;
  ScanPipeline pipeline(nullptr, std::make_unique<OneTarget>(&calls));
  EXPECT_TRUE(pipeline.step(scan_at(0)).elements.empty());
  EXPECT_EQ(calls, "take update with 0");
}

TEST(ScanPipeline, WorksAtTheTimeOfTheReturnsAndAnswersAtTheScans) {
  ScanPipeline pipeline = with_latency(3 * kSecond);
  const PingResult result = pipeline.step(scan_at(10 * kSecond));
  EXPECT_EQ(result.utime, 10 * kSecond);
  ASSERT_EQ(result.tracks.size(), 1U);
  EXPECT_EQ(result.tracks[0].id, 7);
  EXPECT_DOUBLE_EQ(result.tracks[0].state[0], 6.0);           // 3 s at 2 m/s
  EXPECT_DOUBLE_EQ(result.tracks[0].covariance(0, 0), 3.25);  // 1 + 3^2 x 0.25
  EXPECT_DOUBLE_EQ(result.tracks[0].covariance(0, 2), 0.75);  // 3 x 0.25
  EXPECT_DOUBLE_EQ(result.elements[0].position.x(), 6.0);
}

TEST(ScanPipeline, ThePastIsThatOfTheTracker) {
  ScanPipeline pipeline = with_latency(3 * kSecond);
  pipeline.step(scan_at(10 * kSecond));
  EXPECT_EQ(pipeline.retrodict(6 * kSecond)[0].id, 6);
  EXPECT_DOUBLE_EQ(pipeline.retrodict(6 * kSecond)[0].state[0], 0.0);
  // Nothing is known beyond 7 s: from there on tracks keep their course.
  EXPECT_EQ(pipeline.retrodict(9 * kSecond)[0].id, 7);
  EXPECT_DOUBLE_EQ(pipeline.retrodict(9 * kSecond)[0].state[0], 4.0);
}

TEST(ScanPipeline, DecisionsAreOfTheScansTime) {
  std::int64_t utime = 0;
  with_latency(3 * kSecond).explain_to([&utime](const TrackDecision& decision) { utime = decision.utime; });
  EXPECT_EQ(utime, 8 * kSecond);
}

TEST(ScanPipeline, ItsClutterMapIsOfTheScanAndItsSensor) {
  class Learner : public OneTarget {
   public:
    std::optional<core::ClutterGrid> clutter_grid() const override {
      core::ClutterGrid grid;
      grid.utime = 3 * kSecond;  // The time of the returns.
      return grid;
    }
  };
  core::PosedScan scan;
  scan.scan.utime = 5 * kSecond;
  scan.scan.sensor_id = 4;
  ScanPipeline pipeline(nullptr, std::make_unique<Learner>(), 2 * kSecond);
  const auto grid = pipeline.step(scan).clutter_grid();
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->utime, 5 * kSecond);
  EXPECT_EQ(grid->sensor_id, 4);
  ScanPipeline other(nullptr, std::make_unique<OneTarget>());
  EXPECT_FALSE(other.step(scan).clutter_grid());
}

}  // namespace
}  // namespace lookout::tracking
