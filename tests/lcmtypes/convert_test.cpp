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

TEST(Convert, EveryFullMessageFitsOneDatagram) {
  const std::vector tracks(400, example_track(1));
  const std::vector elements(400, example_element());
  auto scan = example_scan();
  scan.returns.resize(kMaxReturns);
  core::GroundTruth truth;
  truth.targets.resize(kMaxTargets);
  EXPECT_LE(encoded(to_wire(kExampleKey, tracks).message).size(), kDatagram);
  EXPECT_LE(encoded(to_wire(kExampleKey, core::EstimatorMethod::csht, 20, elements).message).size(),
            kDatagram);
  EXPECT_LE(encoded(to_wire(scan)).size(), kDatagram);
  EXPECT_LE(encoded(to_wire(truth)).size(), kDatagram);
}

TEST(Convert, RefusesToPublishWhatDoesNotFit) {
  auto scan = example_scan();
  scan.returns.resize(kMaxReturns + 1);
  EXPECT_THROW(to_wire(scan), std::length_error);
  auto image = example_image();
  image.num_bins = core::SonarLimits::kMaxBins + 1;
  image.intensity.assign(2 * static_cast<std::size_t>(image.num_bins), 1.0);
  EXPECT_THROW(to_wire(image), std::length_error);  // More bins than 16 bits count.
  image.num_bins = 3;
  EXPECT_THROW(to_wire(image), std::length_error);  // Sizes that disagree.
  core::GroundTruth truth;
  truth.targets.resize(kMaxTargets + 1);
  EXPECT_THROW(to_wire(truth), std::length_error);
}

TEST(Convert, RefusesNumbersThatAreNotFinite) {
  auto state = to_wire(example_state());
  state.heading = kNan;
  EXPECT_EQ(to_core(state).refusal, "vehicle state: not finite");
  auto scan = to_wire(example_scan());
  scan.range[1] = kNan;
  EXPECT_TRUE(to_core(scan).value);  // A silence, which the intake counts.
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
