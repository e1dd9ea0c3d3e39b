#include "tracking/tracking_chain.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kHour = 3600 * kSecond;

/// Reports one track with a new identity at every scan; in retrospect, one whose state is
/// the time that was asked for, in seconds, and whose identity is still the newest.
class CountingTracker final : public Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan&, std::span<const core::MotionElement>) override {
    ++track_.id;
    return {&track_, 1};
  }
  std::int64_t next_id() const override { return track_.id + 1; }
  void set_next_id(std::int64_t id) override { track_.id = id - 1; }
  bool can_retrodict() const override { return true; }
  std::span<const core::Track> retrodict(std::int64_t utime) override {
    track_.state[0] = core::seconds(utime);
    return {&track_, 1};
  }

 private:
  core::Track track_;
};

class ForgetfulTracker final : public Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan&, std::span<const core::MotionElement>) override {
    return {};
  }
  std::int64_t next_id() const override { return 1; }
  void set_next_id(std::int64_t /*id*/) override {}
};

template <class T>
std::unique_ptr<ScanPipeline> pipeline_of(const core::SonarParams& /*sensor*/) {
  return std::make_unique<ScanPipeline>(nullptr, std::make_unique<T>());
}

/// What came out of a chain: the time of the scan, the track's id and its first coordinate.
struct Given {
  std::int64_t utime;
  std::int64_t id;
  double state;
  bool operator==(const Given&) const = default;
};

class TrackingChainTest : public ::testing::Test {
 protected:
  std::unique_ptr<TrackingChain> chain(std::int64_t lag) {
    ChainParams params;
    params.lag = lag;
    params.sensor.scan_period = 1.0;  // As `feed` is called.
    return std::make_unique<TrackingChain>(
        params, &pipeline_of<CountingTracker>,
        [this](const PingResult& result) {
          given_.push_back({result.utime, result.tracks[0].id, result.tracks[0].state[0]});
        },
        [](const std::string&) {});
  }
  static void feed(TrackingChain& chain, std::int64_t utime, std::int64_t sequence = 0) {
    chain.add(core::VehicleState{utime, {}, {0.0, 0.0}});
    core::SonarScan scan;
    scan.utime = utime;
    scan.sequence = sequence;
    scan.bearing_step = 0.1;
    scan.max_range = 1.0;
    scan.num_beams = 1;
    chain.add(scan);
  }
  std::vector<Given> given_;
};

TEST_F(TrackingChainTest, GivesTracksForEachScanAndUsesNoIdentityTwiceOnANewClock) {
  const auto online = chain(0);
  for (int i = 0; i < 3; ++i) feed(*online, kHour + i * kSecond);
  for (int i = 0; i < 6; ++i) feed(*online, i * kSecond);
  std::vector<std::int64_t> ids;
  for (const auto& given : given_) ids.push_back(given.id);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}));  // None twice.
  EXPECT_EQ(online->counts().resets, 1);
}

// The numbers go on, so that an hour back is a clock that was set: the three scans of before are tracked
// again, in silence.
TEST_F(TrackingChainTest, GoesOnWhereAClockIsSetBackAndTheSensorGoesOn) {
  const auto online = chain(0);
  for (int i = 0; i < 3; ++i) feed(*online, kHour + i * kSecond, i);
  for (int i = 0; i < 6; ++i) feed(*online, i * kSecond, 3 + i);
  ASSERT_EQ(given_.size(), 9u);
  EXPECT_EQ(given_[3], (Given{0, 7, 0.0}));  // The fourth scan of its tracker, which counts 4 to 6 before.
}

TEST_F(TrackingChainTest, StartsAgainWhereAClockLeapsAheadThoughTheNumbersGoOn) {
  const auto online = chain(0);
  for (int i = 0; i < 3; ++i) feed(*online, i * kSecond, i);
  for (int i = 0; i < 6; ++i) feed(*online, kHour + i * kSecond, 3 + i);
  ASSERT_EQ(given_.size(), 9u);
  EXPECT_EQ(given_[3], (Given{kHour, 4, 0.0}));
}

TEST_F(TrackingChainTest, WithALagGivesEachScanOnceAsItIsKnownSoMuchLater) {
  const auto delayed = chain(2 * kSecond);
  for (int i = 0; i < 4; ++i) feed(*delayed, i * kSecond);
  EXPECT_EQ(given_, (std::vector<Given>{{0, 3, 0.0}, {kSecond, 4, 1.0}}));
  delayed->finish();
  ASSERT_EQ(given_.size(), 4u);
  EXPECT_EQ(given_[3], (Given{3 * kSecond, 4, 3.0}));
}

TEST_F(TrackingChainTest, WithALagGivesWhatWaitsBeforeANewClock) {
  const auto delayed = chain(2 * kSecond);
  for (int i = 0; i < 3; ++i) feed(*delayed, kHour + i * kSecond);
  for (int i = 0; i < 5; ++i) feed(*delayed, i * kSecond);
  ASSERT_EQ(given_.size(), 6u);  // The three of the old clock, and those of the new one that are due.
  EXPECT_EQ(given_[2].utime, kHour + 2 * kSecond);
  EXPECT_EQ(given_[3], (Given{0, 6, 0.0}));  // As its tracker knew two scans later: its third, after 1 to 3.
}

TEST_F(TrackingChainTest, RefusesALagThatNobodyCanServe) {
  EXPECT_THROW(chain(-1), std::invalid_argument);
  EXPECT_THROW(chain(61 * kSecond), std::invalid_argument);
  ChainParams params;
  params.lag = 1;
  EXPECT_THROW(
      TrackingChain(
          params, &pipeline_of<ForgetfulTracker>, [](const PingResult&) {}, [](const std::string&) {}),
      std::invalid_argument);
}

TEST(MakePipeline, RefusesADelayThatTheTrackerCannotGive) {
  ChainParams params;
  params.tracker.name = "gnn";
  params.lag = 5 * kSecond;
  EXPECT_THROW(make_pipeline(params, {}), std::invalid_argument);
  params.tracker.name = "joint";
  EXPECT_TRUE(make_pipeline(params, {})->can_retrodict());
}

// What another program writes to have the whole chain.
TEST(TrackingChain, IsFiveLinesForAProgramOfOnesOwn) {
  std::int64_t scans = 0;
  TrackingChain chain(
      {}, [&scans](const PingResult& result) { scans += result.method == core::EstimatorMethod::joint; });
  chain.add(core::VehicleState{0, {}, {0.0, 0.0}});
  core::SonarScan scan;
  scan.first_bearing = -0.5;
  scan.bearing_step = 0.1;
  scan.max_range = 90.0;
  scan.num_beams = 11;
  chain.add(scan);
  chain.finish();
  EXPECT_EQ(scans, 1);
}

/// One confirmed track at the north coordinate of the vehicle, begun at the first scan.
class FollowingTracker final : public Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement>) override {
    if (track_.id == 0) track_.id = next_id_++;
    track_.status = core::TrackStatus::confirmed;
    track_.state[0] = scan.T_earth_sonar.north;
    track_.covariance.setIdentity();
    return {&track_, 1};
  }
  std::int64_t next_id() const override { return next_id_; }
  void set_next_id(std::int64_t id) override { next_id_ = id; }

 private:
  std::int64_t next_id_ = 1;
  core::Track track_;
};

struct FollowingChain {
  void scan(int second) {
    core::SonarScan scan;
    scan.utime = second * kSecond;
    scan.sequence = second;
    scan.bearing_step = 0.1;
    scan.max_range = 100.0;
    scan.num_beams = 3;
    chain.add(core::VehicleState{scan.utime, {1.0 * second, 0.0, 0.0}, {1.0, 0.0}});
    chain.add(scan);
  }
  std::vector<std::int64_t> ids;
  TrackingChain chain{ChainParams(), &pipeline_of<FollowingTracker>,
                      [this](const PingResult& result) { ids.push_back(result.tracks[0].id); },
                      [](const std::string&) {}};
};

/// A chain that says for which sensors its pipelines were made, and what it told.
struct ToldChain {
  void scan(double seconds, std::int64_t sequence, double max_range,
            std::vector<core::SonarReturn> returns = {}) {
    core::SonarScan scan;
    scan.returns = std::move(returns);
    scan.utime = core::microseconds(seconds);
    scan.sequence = sequence;
    scan.bearing_step = 0.1;
    scan.max_range = max_range;
    scan.num_beams = 3;
    chain.add(core::VehicleState{scan.utime, {0.1 * seconds, 0.0, 0.0}, {0.1, 0.0}});
    chain.add(scan);
  }
  std::vector<core::SonarParams> sensors;
  std::vector<std::int64_t> ids;
  std::vector<std::string> lines;
  TrackingChain chain{ChainParams(),
                      [this](const core::SonarParams& sensor) {
                        sensors.push_back(sensor);
                        return pipeline_of<FollowingTracker>(sensor);
                      },
                      [this](const PingResult& result) { ids.push_back(result.tracks[0].id); },
                      [this](const std::string& line) { lines.push_back(line); }};
};

// No message states a period, and a tracker that was told half a second finds nothing in scans 6 s apart.
TEST(TrackingChainPace, GoesByTheScansAndKeepsGeometryAndIdentities) {
  ToldChain told;
  for (int k = 0; k < 10; ++k) told.scan(6.0 * k, k, 100.0);
  EXPECT_EQ(told.ids, std::vector<std::int64_t>(10, 1));
  EXPECT_DOUBLE_EQ(told.sensors.back().scan_period, 6.0);
  EXPECT_EQ(told.sensors.back().num_beams, 3);
  EXPECT_EQ(told.lines.back(),
            "scans come every 6 s, not every 0.5 s: tracking goes by that; scan_period in `sensor:` of the "
            "configuration says it from the start");
}

// At 3 m/s a target crosses the view of 100 m between two scans a minute apart: half of it is looked for.
TEST(TrackingChainPace, LooksForNoTargetThatCrossesTheViewBetweenTwoScans) {
  ToldChain told;
  for (int k = 0; k < 10; ++k) told.scan(60.0 * k, k, 100.0);
  EXPECT_DOUBLE_EQ(told.sensors.back().max_speed, 0.5 * 100.0 / 60.0);
  EXPECT_EQ(told.ids, std::vector<std::int64_t>(10, 1));
}

TEST(TrackingChainPace, SaysWhereTheTrackerCannotBeMadeForIt) {
  std::vector<std::string> lines;
  int scans = 0;
  TrackingChain chain(
      {},
      [](const core::SonarParams& sensor) {
        if (sensor.scan_period > 1.0) throw std::invalid_argument("too slow");
        return pipeline_of<FollowingTracker>(sensor);
      },
      [&scans](const PingResult&) { ++scans; }, [&lines](const std::string& line) { lines.push_back(line); });
  for (int k = 0; k < 10; ++k) {
    core::SonarScan scan;
    scan.utime = 6 * kSecond * k;
    scan.sequence = k;
    scan.bearing_step = 0.1;
    scan.max_range = 100.0;
    scan.num_beams = 3;
    chain.add(core::VehicleState{scan.utime, {0.1 * k, 0.0, 0.0}, {0.0, 0.0}});
    chain.add(scan);
  }
  EXPECT_EQ(scans, 10);
  EXPECT_NE(lines.back().find("for which this tracker cannot be made"), std::string::npos);
}

// No message says that all returns of a beam count: the twelfth scan shows it, of two returns in one beam
// each.
TEST(TrackingChainReturns, ReadsABeamOfSeveralReturnsAsPoints) {
  ToldChain told;
  for (int k = 0; k < 14; ++k) told.scan(0.5 * k, k, 100.0, {{0.0, 20.0 + k}, {0.0, 40.0 + k}});
  EXPECT_EQ(told.ids, std::vector<std::int64_t>(14, 1));
  ASSERT_TRUE(told.sensors.back().point_sensor());
  EXPECT_EQ(*told.sensors.back().clutter_per_scan, 2.0);
  EXPECT_EQ(told.lines.back(),
            "beams report several returns: all of them count, 2 a scan; clutter_per_scan in `sensor:` of the "
            "configuration says how many from the start");
}

// The default of 3 m is that of a sonar of 150 m.
TEST(TrackingChainScale, TakesNoDefaultSigmaThatIsHalfTheRange) {
  ToldChain imaging, usual;
  imaging.scan(0.0, 0, 5.0);
  EXPECT_DOUBLE_EQ(imaging.sensors.back().range_sigma, 0.1);
  EXPECT_EQ(
      imaging.lines.back(),
      "range_sigma 3 m in a range of 5 m: 0.1 m is taken; range_sigma in `sensor:` of the configuration "
      "says what is right");
  usual.scan(0.0, 0, 60.0);
  EXPECT_DOUBLE_EQ(usual.sensors.back().range_sigma, 3.0);
}

TEST(TrackingChainRestart, GoesOnInSilenceWithTheSameIdentities) {
  FollowingChain before, after;
  before.chain.remember();
  for (int k = 0; k < 10; ++k) before.scan(k);
  EXPECT_EQ(after.chain.restore(before.chain.memory()), 1u);
  EXPECT_TRUE(after.ids.empty());
  EXPECT_EQ(after.chain.counts().accepted, 0);
  for (int k = 12; k < 15; ++k) after.scan(k);
  EXPECT_EQ(after.ids, (std::vector<std::int64_t>{1, 1, 1}));
  EXPECT_EQ(after.chain.counts().lost, 2);
}

TEST(TrackingChainRestart, TracksTheFirstScanAfterIt) {
  FollowingChain before, after;
  before.chain.remember();
  for (int k = 0; k < 10; ++k) before.scan(k);
  after.chain.restore(before.chain.memory());
  after.scan(30);  // A pause that would be held until the next scan agrees.
  EXPECT_EQ(after.ids.size(), 1u);
}

TEST(TrackingChainRestart, NeverUsesAnIdentityAgain) {
  FollowingChain before, after;
  before.chain.remember();
  before.scan(0);
  core::TrackingMemory memory = before.chain.memory();
  memory.tracks[0].state[0] = 500.0;  // Not there any more.
  EXPECT_EQ(after.chain.restore(memory), 0u);
  after.scan(1);
  EXPECT_GE(after.ids.at(0), memory.next_id);
}

TEST(TrackingChainRestart, ARestartAfterARestartHasTheSameIdentities) {
  FollowingChain first, second, third;
  first.chain.remember();
  for (int k = 0; k < 3; ++k) first.scan(k);
  second.chain.restore(first.chain.memory());
  second.scan(3);
  third.chain.restore(second.chain.memory());
  third.scan(4);
  EXPECT_EQ(third.ids, std::vector<std::int64_t>{1});
}

}  // namespace
}  // namespace lookout::tracking
