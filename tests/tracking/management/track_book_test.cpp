#include "tracking/management/track_book.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lookout::tracking {
namespace {

core::PosedScan scan_at(std::int64_t utime) {
  core::PosedScan scan;
  scan.scan.utime = utime;
  return scan;
}

TEST(TrackBook, IdentitiesAreNeverUsedAgain) {
  TrackBook book({});
  book.begin(0, {50.0, 0.0, 0.0, 0.0}, Eigen::Matrix4d::Identity());
  for (int k = 1; k <= 3; ++k) book.step(scan_at(k), {}, std::vector<double>(book.tracks().size(), 0.0));
  ASSERT_TRUE(book.tracks().empty());
  book.begin(4, {50.0, 0.0, 0.0, 0.0}, Eigen::Matrix4d::Identity());
  EXPECT_EQ(book.tracks()[0].id, 2);
}

TEST(TrackBook, KeepsTheOthersWhenOneEnds) {
  TrackBook book({});
  for (const double north : {40.0, 60.0, 80.0})
    book.begin(0, {north, 0.0, 0.0, 0.0}, Eigen::Matrix4d::Identity());
  for (int k = 1; k <= 2; ++k) book.step(scan_at(k), {}, std::vector{1.0, 0.0, 1.0});
  ASSERT_EQ(book.tracks().size(), 2U);
  EXPECT_EQ(book.tracks()[0].id, 1);
  EXPECT_EQ(book.tracks()[1].id, 3);
  EXPECT_EQ(book.life(1).hits(), 3);
}

TEST(TrackBook, OutsideTheSectorATrackCoasts) {
  TrackBook book({});
  book.begin(0, {-50.0, 0.0, 0.0, 0.0}, Eigen::Matrix4d::Identity());  // behind the vehicle
  book.step(scan_at(1), {}, std::vector{1.0});
  ASSERT_EQ(book.tracks().size(), 1U);
  EXPECT_EQ(book.tracks()[0].status, core::TrackStatus::coasting);
}

TEST(TrackBook, TellsWhatItDecidesWithItsCounts) {
  TrackBook book({.confirm_hits = 2, .confirm_scans = 3});
  std::string told;
  book.explain_to([&told](const TrackDecision& decision) {
    told += std::to_string(decision.utime) + " " + to_string(decision.kind) + ", " + evidence_text(decision) +
            ", " + decision.reason + "\n";
  });
  book.begin(0, {50.0, 0.0, 0.0, 0.0}, Eigen::Matrix4d::Identity());
  for (int k = 1; k <= 4; ++k)
    book.step(scan_at(k), {}, std::vector<double>(book.tracks().size(), k == 1 ? 1.0 : 0.0));
  EXPECT_EQ(told,
            "0 begin, supported in 1 of 1 scans, a detection that no track took\n"
            "1 confirm, supported in 2 of 2 scans, supported often enough since its beginning\n"
            "3 end, supported in 2 of 4 scans, missed in 2 since, missed too often in a row\n");
}

TEST(TrackBook, PredictsFromScanToScan) {
  TrackBook book({});
  book.predict_to(2'000'000, {});
  book.begin(2'000'000, {50.0, 0.0, 1.0, 2.0}, Eigen::Matrix4d::Identity());
  book.predict_to(3'500'000, {.acceleration_sigma = 0.0});
  EXPECT_TRUE(book.tracks()[0].position().isApprox(Eigen::Vector2d(51.5, 3.0)));
}

}  // namespace
}  // namespace lookout::tracking
