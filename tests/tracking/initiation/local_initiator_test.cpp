#include "tracking/initiation/local_initiator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace lookout::tracking {
namespace {

/// Remembers what it was shown; proposes the course through the oldest and the newest plot of it.
class Onlooker : public Initiator {
 public:
  Onlooker(std::vector<PlotWindow>& shown, std::string refusal)
      : shown_(shown), refusal_(std::move(refusal)) {}

  const StartedTracks& start(const PlotWindow& window) override {
    shown_.push_back(window);
    started_.clear();
    started_.refusal = refusal_;
    if (window.num_plots() >= 2) add_track(window, std::array{0, window.num_plots() - 1}, {}, 1.0, started_);
    return started_;
  }
  int window_scans() const override { return 4; }

 private:
  std::vector<PlotWindow>& shown_;
  std::string refusal_;
  StartedTracks started_;
};

Plot plot_at(double x, double y) {
  Plot plot;
  plot.position = {x, y};
  plot.noise = Eigen::Matrix2d::Identity();
  plot.clutter_density = 1e-4;
  return plot;
}

/// Ten scans of a target that is 1 m farther in each, and of a rock 50 m away in the first nine.
PlotWindow target_and_rock() {
  PlotWindow window;
  for (int k = 0; k < 10; ++k) {
    window.begin_scan(0.5 * k);
    window.add(plot_at(100.0, 1.0 * k));
    if (k < 9) window.add(plot_at(150.0, 0.0));
  }
  return window;
}

LocalInitiatorParams every_third() {
  LocalInitiatorParams params;
  params.stride = 3;
  params.margin = 2.0;
  return params;
}

// Scans 0, 3, 6 and 9, without the rock, around the middle of 0, 3, 6 and 9 m.
TEST(LocalInitiator, ShowsEveryStrideThScanWithinReachAroundItsMiddle) {
  std::vector<PlotWindow> shown;
  LocalInitiator local(std::make_unique<Onlooker>(shown, ""), every_third());
  local.start(target_and_rock());
  ASSERT_EQ(shown.size(), 1u);
  ASSERT_EQ(shown[0].num_scans(), 4);
  ASSERT_EQ(shown[0].num_plots(), 4);
  for (int k = 0; k < 4; ++k) {
    EXPECT_DOUBLE_EQ(shown[0].time(k), 1.5 * k);
    EXPECT_LT((shown[0].plot(k).position - Eigen::Vector2d(0.0, 3.0 * k - 4.5)).norm(), 1e-12);
  }
}

// What is proposed of four scans stands in all ten.
TEST(LocalInitiator, AProposalThatStandsInAllScansIsATrack) {
  std::vector<PlotWindow> shown;
  LocalInitiator local(std::make_unique<Onlooker>(shown, ""), every_third());
  const StartedTracks& started = local.start(target_and_rock());
  ASSERT_EQ(started.tracks.size(), 1u);
  EXPECT_EQ(started.tracks[0].num_plots, 10);
  EXPECT_LT((started.tracks[0].state - Eigen::Vector4d(100.0, 9.0, 0.0, 2.0)).norm(), 1e-6);
}

// Two plots of the newest scan see the same course: it starts once.
TEST(LocalInitiator, OnePlotServesOneTrack) {
  std::vector<PlotWindow> shown;
  LocalInitiator local(std::make_unique<Onlooker>(shown, ""), every_third());
  PlotWindow window = target_and_rock();
  window.add(plot_at(100.5, 9.2));
  EXPECT_EQ(local.start(window).tracks.size(), 1u);
  EXPECT_EQ(shown.size(), 2u);
}

TEST(LocalInitiator, ARefusalStartsNothing) {
  std::vector<PlotWindow> shown;
  LocalInitiator local(std::make_unique<Onlooker>(shown, "too many"), every_third());
  const StartedTracks& started = local.start(target_and_rock());
  EXPECT_EQ(started.refusal, "too many");
  EXPECT_TRUE(started.tracks.empty());
}

TEST(LocalInitiator, KeepsScansForTheMethodAndForTheProof) {
  std::vector<PlotWindow> shown;
  LocalInitiatorParams params = every_third();
  EXPECT_EQ(LocalInitiator(std::make_unique<Onlooker>(shown, ""), params).window_scans(), 10);
  params.stride = 5;  // Scans 0, 5, 10 and 15.
  EXPECT_EQ(LocalInitiator(std::make_unique<Onlooker>(shown, ""), params).window_scans(), 16);
  params.stride = 0;
  EXPECT_THROW(LocalInitiator(std::make_unique<Onlooker>(shown, ""), params), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
