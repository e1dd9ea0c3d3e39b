#include "tracking/tracking_chain.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kHour = 3600 * kSecond;

/// Reports one track whose id counts the scans since the tracker was made.
class CountingTracker final : public Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan&) override {
    ++track_.id;
    return {&track_, 1};
  }

 private:
  core::Track track_;
};

TEST(TrackingChain, GivesTracksForEachScanAndANewTrackerToANewClock) {
  std::vector<std::int64_t> ids;
  TrackingChain chain(
      core::SonarParams(), [](const core::SonarParams&) { return std::make_unique<CountingTracker>(); },
      [&](const core::PosedScan&, std::span<const core::Track> tracks, const Tracker&) {
        ids.push_back(tracks[0].id);
      },
      [](const std::string&) {});
  const auto feed = [&chain](std::int64_t utime) {
    chain.add(core::VehicleState{utime, {}, {0.0, 0.0}});
    core::SonarScan scan;
    scan.utime = utime;
    scan.bearing_step = 0.1;
    scan.max_range = 1.0;
    scan.num_beams = 1;
    chain.add(scan);
  };
  for (int i = 0; i < 3; ++i) feed(kHour + i * kSecond);
  for (int i = 0; i < 6; ++i) feed(i * kSecond);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2, 3, 1, 2}));
  EXPECT_EQ(chain.counts().resets, 1);
}

}  // namespace
}  // namespace lookout::tracking
