#include "tracking/track_before_detect/frames/h_pmht.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "tests/tracking/track_before_detect/frame_maker.hpp"

namespace lookout::tracking {
namespace {

const Eigen::Matrix4d kStartCovariance = Eigen::Vector4d(4.0, 4.0, 0.04, 0.04).asDiagonal();

/// A dark frame with bright discs of radius 4 and intensity 8 at the centres.
IntensityFrame discs(int columns, int rows, const std::vector<Eigen::Vector2d>& centres) {
  IntensityFrame frame{columns, rows, std::vector<double>(static_cast<std::size_t>(columns * rows), 1.0)};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (const auto& centre : centres)
        if ((Eigen::Vector2d(column + 0.5, row + 0.5) - centre).norm() < 4.0)
          frame.values[frame.index(column, row)] = 8.0;
  return frame;
}

HPmhtParams disc_params(HPmhtParams params) {
  params.target_area = 50.0;  // pi 4^2
  return params;
}

FrameTrack step(FrameTracker& tracker, const IntensityFrame& frame, double time = 1.0) {
  return tracker.process({&frame, 1}, {&time, 1}).back().front();
}

TEST(HPmht, AStillDiscIsFoundFromThreePixelsOff) {
  for (const auto& params : {with_dark_cells(improved_h_pmht_4()), with_dark_cells(improved_h_pmht_1())}) {
    const auto tracker = make_h_pmht(disc_params(params));
    tracker->add(1, {43.0, 30.0, 0.0, 0.0}, kStartCovariance);
    FrameTrack track;
    for (int i = 0; i < 8; ++i) track = step(*tracker, discs(80, 60, {{40.0, 30.0}}));
    EXPECT_NEAR(track.state[0], 40.0, 0.05);  // the centre lies on a corner of four cells
    EXPECT_NEAR(track.state[1], 30.0, 0.05);
    EXPECT_NEAR(track.state[2], 0.0, 0.1);
  }
}

TEST(HPmht, ABatchFollowsAMovingDisc) {
  const auto tracker = make_h_pmht(with_dark_cells(disc_params(standard_h_pmht())));
  tracker->add(1, {20.0, 30.0, 2.0, 0.0}, kStartCovariance);
  std::vector<IntensityFrame> frames;
  for (int t = 1; t <= 5; ++t) frames.push_back(discs(80, 60, {{20.0 + 2.0 * t, 30.0 + 0.5 * t}}));
  const std::vector<double> steps(5, 1.0);
  const auto& tracks = tracker->process(frames, steps);
  ASSERT_EQ(tracks.size(), 5u);
  for (int t = 1; t <= 5; ++t) {
    EXPECT_NEAR(tracks[static_cast<std::size_t>(t - 1)][0].state[0], 20.0 + 2.0 * t, 0.3);
    EXPECT_NEAR(tracks[static_cast<std::size_t>(t - 1)][0].state[1], 30.0 + 0.5 * t, 0.3);
  }
}

TEST(HPmht, FormsGiveTheSameTracks) {
  core::Random random(1000);
  const IntensityFrame frame = noisy_frame(60, 50, {26, 20}, random);
  const auto run = [&](CellForm form, Truncation truncation) {
    HPmhtParams params = improved_h_pmht_4();
    params.form = form;
    params.truncation = truncation;
    const auto tracker = make_h_pmht(params);
    tracker->add(1, {30.0, 24.0, 0.0, 0.0}, kStartCovariance);
    return step(*tracker, frame).state;
  };
  for (const Truncation truncation : {Truncation::impute, Truncation::zero}) {
    const Eigen::Vector4d printed = run(CellForm::per_cell, truncation);
    EXPECT_LT((run(CellForm::separable, truncation) - printed).norm(), 1e-9 * printed.norm());
    EXPECT_LT((run(CellForm::sparse, truncation) - printed).norm(), 1e-9 * printed.norm());
  }
  EXPECT_LT((run(CellForm::gated, Truncation::zero) - run(CellForm::per_cell, Truncation::zero)).norm(),
            1e-3);
}

TEST(HPmht, AnEmptyFrameCoasts) {
  for (const auto& mode : {standard_h_pmht(), improved_h_pmht_4(), improved_h_pmht_1()})
    for (const Truncation truncation : {Truncation::impute, Truncation::zero}) {
      HPmhtParams params = disc_params(mode);
      params.truncation = truncation;
      const auto tracker = make_h_pmht(params);
      tracker->add(1, {30.0, 20.0, 2.0, 1.0}, kStartCovariance);
      const FrameTrack track = step(*tracker, discs(80, 60, {}));
      EXPECT_EQ(track.state, Eigen::Vector4d(32.0, 21.0, 2.0, 1.0));
      EXPECT_GT(track.covariance(0, 0), kStartCovariance(0, 0));
    }
}

TEST(HPmht, ASaturatedFrameStaysFinite) {
  for (const auto& mode : {standard_h_pmht(), with_dark_cells(improved_h_pmht_4())}) {
    const auto tracker = make_h_pmht(disc_params(mode));
    tracker->add(1, {30.0, 20.0, 0.0, 0.0}, kStartCovariance);
    IntensityFrame frame = discs(80, 60, {});
    frame.values.assign(frame.values.size(), 65535.0);
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(step(*tracker, frame).state.allFinite());
  }
}

TEST(HPmht, TwoCrossingTargetsKeepTheirVelocities) {
  HPmhtParams params = with_dark_cells(disc_params(improved_h_pmht_4()));
  params.noise_density = 0.01;  // agile targets of one look may as well bounce off each other
  const auto tracker = make_h_pmht(params);
  tracker->add(1, {20.0, 20.0, 2.0, 1.0}, kStartCovariance);
  tracker->add(2, {20.0, 40.0, 2.0, -1.0}, kStartCovariance);
  std::vector<FrameTrack> tracks;
  for (int t = 1; t <= 20; ++t) {
    const double one = 1.0;
    const IntensityFrame frame =
        discs(100, 60, {{20.0 + 2.0 * t, 20.0 + 1.0 * t}, {20.0 + 2.0 * t, 40.0 - 1.0 * t}});
    tracks = tracker->process({&frame, 1}, {&one, 1}).back();
  }
  // They meet at t = 10 at (40, 30); each continues its own way.
  EXPECT_NEAR(tracks[0].state[1], 40.0, 1.0);
  EXPECT_NEAR(tracks[1].state[1], 20.0, 1.0);
}

TEST(HPmht, ATargetThatLeavesIsLost) {
  const auto tracker = make_h_pmht(with_dark_cells(disc_params(improved_h_pmht_4())));
  tracker->add(1, {74.0, 30.0, 2.0, 0.0}, kStartCovariance);
  FrameTrack track;
  for (int t = 1; t <= 6; ++t) {
    track = step(*tracker, discs(80, 60, {{74.0 + 2.0 * t, 30.0}}));
    EXPECT_TRUE(track.state.allFinite());
  }
  EXPECT_TRUE(track.lost);
}

TEST(HPmht, AGapInTheFramesIsPredictedAcross) {
  const auto tracker = make_h_pmht(with_dark_cells(disc_params(improved_h_pmht_4())));
  tracker->add(1, {20.0, 30.0, 2.0, 0.0}, kStartCovariance);
  step(*tracker, discs(80, 60, {{22.0, 30.0}}));
  const FrameTrack track = step(*tracker, discs(80, 60, {{30.0, 30.0}}), 4.0);  // three frames missing
  EXPECT_NEAR(track.state[0], 30.0, 0.5);
}

TEST(HPmht, ThePrintedProcessNoiseIgnoresTheData) {
  // At a batch of one Eq. (23) is a single outer product: on a straight path it vanishes.
  HPmhtParams params = disc_params(improved_h_pmht_4());
  params.process_noise = ProcessNoise::printed;
  const auto tracker = make_h_pmht(params);
  tracker->add(1, {20.0, 30.0, 2.0, 0.0}, Eigen::Matrix4d::Zero());
  for (int t = 1; t <= 5; ++t) step(*tracker, discs(80, 60, {{20.0 + 2.0 * t, 30.0}}));
  const FrameTrack track = step(*tracker, discs(80, 60, {{32.0, 35.0}}));  // it jumps by 5 px
  EXPECT_LT(std::abs(track.state[1] - 30.0), 1.0);
}

TEST(HPmht, RefusesFramesOfChangingSizeAndNaN) {
  const auto tracker = make_h_pmht(improved_h_pmht_4());
  tracker->add(1, {20.0, 30.0, 0.0, 0.0}, kStartCovariance);
  step(*tracker, discs(80, 60, {}));
  EXPECT_THROW(step(*tracker, discs(80, 61, {})), std::invalid_argument);
  IntensityFrame frame = discs(80, 60, {});
  frame.values[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(step(*tracker, frame), std::invalid_argument);
}

TEST(HPmht, RefusesParametersOutOfRangeWithTheValue) {
  HPmhtParams params;
  params.target_weight = 1.5;
  try {
    make_h_pmht(params);
    FAIL() << "a weight of 1.5 passed";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("1.5"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lookout::tracking
