#include "lcmtypes/convert.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

using namespace lookout::tests;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kDatagram = 65'499;  // Largest payload of a UDP datagram that LCM sends whole.

TEST(Convert, VehicleStateThereAndBack) {
  const auto back = to_core(to_wire(example_state())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, 1'500'000);
  EXPECT_EQ(back->T_earth_body.north, 10.5);
  EXPECT_EQ(back->T_earth_body.east, -20.25);
  EXPECT_EQ(back->T_earth_body.heading, 0.75);
  EXPECT_EQ(back->velocity, Eigen::Vector2d(0.5, -0.25));
}

TEST(Convert, ScanThereAndBack) {
  const auto back = to_core(to_wire(example_scan())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, 2'000'000);
  EXPECT_EQ(back->sequence, 4);
  EXPECT_EQ(back->sensor_id, 7);
  EXPECT_EQ(back->T_body_sonar.north, 1.5);
  EXPECT_EQ(back->T_body_sonar.east, -0.5);
  EXPECT_EQ(back->T_body_sonar.heading, 0.125);
  EXPECT_EQ(back->first_bearing, -0.75);
  EXPECT_EQ(back->bearing_step, 0.0175);
  EXPECT_EQ(back->max_range, 150.0);
  EXPECT_EQ(back->num_beams, 90);
  ASSERT_EQ(back->returns.size(), 2u);
  EXPECT_EQ(back->returns[1].bearing, 0.25);
  EXPECT_EQ(back->returns[1].range, 120.5);
  EXPECT_EQ(back->returns[1].intensity, 0.5);
}

TEST(Convert, ImageThereAndBack) {
  const auto back = to_core(to_wire(example_image())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->sequence, 5);
  EXPECT_EQ(back->first_range, 1.0);
  EXPECT_EQ(back->range_step, 0.25);
  EXPECT_EQ(back->num_beams, 2);
  EXPECT_EQ(back->num_bins, 3);
  EXPECT_EQ(back->intensity, example_image().intensity);
}

TEST(Convert, ImageIntensityIsWithinHalfAStepOfTheLargest) {
  auto image = example_image();
  image.intensity = {0.1, 0.2, 0.3, 0.4, 0.5, 1.7};
  const auto back = to_core(to_wire(image)).value;
  for (std::size_t i = 0; i < image.intensity.size(); ++i)
    EXPECT_NEAR(back->intensity[i], image.intensity[i], 0.5 * 1.7 / 32767);
}

TEST(Convert, GroundTruthThereAndBack) {
  const auto back = to_core(to_wire(example_truth())).value;
  ASSERT_TRUE(back);
  ASSERT_EQ(back->targets.size(), 2u);
  EXPECT_EQ(back->targets[1].id, 2);
  EXPECT_EQ(back->targets[1].position, Eigen::Vector2d(5, 6));
  EXPECT_EQ(back->targets[1].velocity, Eigen::Vector2d(7, 8));
  EXPECT_TRUE(back->targets[0].visible);
  EXPECT_FALSE(back->targets[1].visible);
}

TEST(Convert, ElementsThereAndBack) {
  const auto back = to_core(example_wire(static_cast<const motion_elements_t*>(nullptr))).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->key.sequence, 4);
  EXPECT_EQ(back->method, core::EstimatorMethod::sht);
  EXPECT_EQ(back->window_scans, 20);
  ASSERT_EQ(back->elements.size(), 2u);
  const auto& element = back->elements[0];
  EXPECT_EQ(element.initial_utime, 1'000'000);
  EXPECT_EQ(element.initial_position, Eigen::Vector2d(1, 2));
  EXPECT_EQ(element.state(), Eigen::Vector4d(5, 6, 3, 4));
  EXPECT_EQ(element.covariance, example_element().covariance);
  EXPECT_EQ(element.score, 7.0);
  EXPECT_EQ(element.existence, 0.5);
  EXPECT_EQ(element.support, 8);
}

TEST(Convert, TracksThereAndBack) {
  const auto back = to_core(example_wire(static_cast<const track_list_t*>(nullptr))).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->key.utime, 2'000'000);
  EXPECT_EQ(back->key.source_id, 7);
  ASSERT_EQ(back->tracks.size(), 2u);
  const auto& track = back->tracks[1];
  EXPECT_EQ(track.id, 2);
  EXPECT_EQ(track.status, core::TrackStatus::coasting);
  EXPECT_EQ(track.state, Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_EQ(track.covariance, example_track(2).covariance);
  EXPECT_EQ(track.existence, 0.75);
  EXPECT_EQ(track.first_utime, 500'000);
  EXPECT_EQ(track.last_detection_utime, 1'500'000);
}

TEST(Convert, SensorEstimateThereAndBack) {
  const auto back = to_core(to_wire(kExampleKey, example_sensor_estimate())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->key.sequence, 4);
  EXPECT_EQ(back->estimate.miss_probability, 0.25);
  EXPECT_EQ(back->estimate.false_alarm_probability, 0.125);
  EXPECT_EQ(back->estimate.range_sigma, 3.0);
  EXPECT_EQ(back->estimate.miss_probability_sigma, 0.01);
  EXPECT_EQ(back->estimate.false_alarm_probability_sigma, 0.02);
  EXPECT_EQ(back->estimate.range_sigma_sigma, 0.03);
}

TEST(Convert, LocalEstimateThereAndBackWithAndWithoutCovariance) {
  auto estimate = example_local_estimate();
  const auto back = to_core(to_wire(estimate)).value;
  ASSERT_TRUE(back && back->covariance);
  EXPECT_EQ(*back->covariance, *estimate.covariance);
  EXPECT_EQ(back->node_id, 2);
  EXPECT_EQ(back->p_earth_node, Eigen::Vector2d(1, -1));
  EXPECT_EQ(back->track_id, 99);
  EXPECT_EQ(back->state, Eigen::Vector4d(1, 2, 3, 4));
  estimate.covariance.reset();
  const auto without = to_core(to_wire(estimate)).value;
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->covariance);
}

TEST(Convert, ALongListKeepsItsMostProbableInTheirOrder) {
  std::vector<core::Track> tracks;
  for (int id = 0; id < 302; ++id) tracks.push_back(example_track(id, 0.5));
  tracks[0].existence = 0.1;
  tracks[150].existence = 0.2;
  const auto listed = to_wire(kExampleKey, tracks);
  EXPECT_EQ(listed.left_out, 2u);
  ASSERT_EQ(listed.message.tracks.size(), 300u);
  EXPECT_EQ(listed.message.tracks.front().id, 1);
  EXPECT_EQ(listed.message.tracks[149].id, 151);
  EXPECT_EQ(listed.message.tracks.back().id, 301);
}

TEST(Convert, EveryFullMessageFitsOneDatagram) {
  const std::vector tracks(400, example_track(1));
  const std::vector elements(400, example_element());
  auto scan = example_scan();
  scan.returns.resize(kMaxReturns);
  auto image = example_image();
  image.num_beams = 100;
  image.num_bins = 327;
  image.intensity.assign(kMaxPixels, 1.0);
  core::GroundTruth truth;
  truth.targets.resize(kMaxTargets);
  EXPECT_LE(encoded(to_wire(kExampleKey, tracks).message).size(), kDatagram);
  EXPECT_LE(encoded(to_wire(kExampleKey, core::EstimatorMethod::csht, 20, elements).message).size(),
            kDatagram);
  EXPECT_LE(encoded(to_wire(scan)).size(), kDatagram);
  EXPECT_LE(encoded(to_wire(image)).size(), kDatagram);
  EXPECT_LE(encoded(to_wire(truth)).size(), kDatagram);
}

TEST(Convert, RefusesToPublishWhatDoesNotFit) {
  auto scan = example_scan();
  scan.returns.resize(kMaxReturns + 1);
  EXPECT_THROW(to_wire(scan), std::length_error);
  auto image = example_image();
  image.num_beams = 1;
  image.num_bins = static_cast<int>(kMaxPixels) + 1;
  image.intensity.assign(kMaxPixels + 1, 1.0);
  EXPECT_THROW(to_wire(image), std::length_error);
  core::GroundTruth truth;
  truth.targets.resize(kMaxTargets + 1);
  EXPECT_THROW(to_wire(truth), std::length_error);
}

TEST(Convert, TheImageOfTheDesignFits) {  // 90 x 300 is 54,096 bytes: 96 of header, 2 a cell.
  auto image = example_image();
  image.num_beams = 90;
  image.num_bins = 300;
  image.intensity.assign(90 * 300, 0.5);
  EXPECT_EQ(encoded(to_wire(image)).size(), 54'096u);
}

TEST(Convert, RefusesNumbersThatAreNotFinite) {
  auto state = to_wire(example_state());
  state.heading = kNan;
  EXPECT_EQ(to_core(state).refusal, "vehicle state: not finite");
  auto scan = to_wire(example_scan());
  scan.range[1] = kNan;
  EXPECT_EQ(to_core(scan).refusal, "scan: returns not finite");
  scan = to_wire(example_scan());
  scan.max_range = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_core(scan).refusal, "scan: header not finite");
  auto image = to_wire(example_image());
  image.range_step = kNan;
  EXPECT_EQ(to_core(image).refusal, "image: header not finite");
  auto tracks = example_wire(static_cast<const track_list_t*>(nullptr));
  tracks.tracks[1].covariance[3][3] = kNan;
  EXPECT_EQ(to_core(tracks).refusal, "tracks: an entry is damaged");
  auto estimate = to_wire(example_local_estimate());
  estimate.node_east = kNan;
  EXPECT_EQ(to_core(estimate).refusal, "local estimate: not finite");
}

TEST(Convert, RefusesCountsThatDisagreeWithTheLists) {
  auto scan = to_wire(example_scan());
  scan.num_returns = 3;
  EXPECT_FALSE(to_core(scan).value);
  auto image = to_wire(example_image());
  image.intensity[1].pop_back();
  EXPECT_FALSE(to_core(image).value);
  auto truth = to_wire(example_truth());
  truth.num_targets = -1;
  EXPECT_FALSE(to_core(truth).value);
  auto estimate = to_wire(example_local_estimate());
  estimate.num_covariance = 15;
  estimate.covariance.resize(15);
  EXPECT_FALSE(to_core(estimate).value);
}

TEST(Convert, RefusesCodesFlagsProbabilitiesAndTimesOutOfRange) {
  auto truth = to_wire(example_truth());
  truth.targets[0].visible = 2;
  EXPECT_FALSE(to_core(truth).value);
  auto elements = example_wire(static_cast<const motion_elements_t*>(nullptr));
  elements.method = 6;
  EXPECT_FALSE(to_core(elements).value);
  auto tracks = example_wire(static_cast<const track_list_t*>(nullptr));
  tracks.tracks[0].status = 3;
  EXPECT_FALSE(to_core(tracks).value);
  auto estimate = to_wire(kExampleKey, example_sensor_estimate());
  estimate.miss_probability = 1.5;
  EXPECT_FALSE(to_core(estimate).value);
  auto state = to_wire(example_state());
  state.utime = std::numeric_limits<std::int64_t>::min();
  EXPECT_FALSE(to_core(state).value);
}

}  // namespace
}  // namespace lookout::lcmtypes
