#include "tracking/node/detector_node.hpp"

#include <gtest/gtest.h>

#include <lookout/node_status_t.hpp>
#include <string>
#include <vector>

#include "core/input_error.hpp"
#include "lcmtypes/convert.hpp"
#include "tests/support/speckle_images.hpp"

namespace lookout::tracking {
namespace {

class DetectorNodeTest : public ::testing::Test {
 protected:
  DetectorNodeTest() {
    bus_.subscribe<sonar_scan_t>("AUV1_SONAR_SCAN", [this](core::SonarScan scan) { scans_.push_back(scan); });
    bus_.subscribe_bytes("AUV1_LOOKOUT_STATUS", [this](auto bytes) {
      status_ = lcmtypes::decode<node_status_t>(bytes.data(), bytes.size());
    });
  }
  void publish(const core::SonarImage& image) { bus_.publish("AUV1_SONAR_IMAGE", lcmtypes::to_wire(image)); }
  /// Handles what was published, and publishes the status.
  void run() {
    lcmtypes::LoopLimits limits;
    limits.stopped = [] { return true; };
    node_.run(limits);
    bus_.drain();
  }

  lcmtypes::Bus bus_{"memq://"};
  std::vector<std::string> lines_;
  DetectorNode node_{bus_, "AUV1_", {}, [this](const std::string& line) { lines_.push_back(line); }};
  std::vector<core::SonarScan> scans_;
  std::optional<node_status_t> status_;
};

TEST_F(DetectorNodeTest, GivesAScanForEachImage) {
  lookout::testing::SpeckleImages images({}, 4);
  for (int ping = 0; ping < 3; ++ping) publish(images.next({{40.0, 200.0, 30.0}}));
  run();
  ASSERT_EQ(scans_.size(), 3U);
  EXPECT_EQ(scans_[2].sequence, 2);
  EXPECT_EQ(scans_[2].utime, 1'000'000);
  ASSERT_FALSE(scans_[2].returns.empty());
  // Beam 40 of -0.5 + 0.01 k, bin 200 of 2 + 0.1 k.
  EXPECT_NEAR(scans_[2].returns[0].bearing, -0.1, 0.002);
  EXPECT_NEAR(scans_[2].returns[0].range, 22.0, 0.02);
  ASSERT_TRUE(status_);
  EXPECT_EQ(status_->node, "lookout detect");
  EXPECT_EQ(status_->accepted, 3);
  EXPECT_EQ(status_->rejected, 0);
}

TEST_F(DetectorNodeTest, CountsWhatIsDamagedAndWhatIsLost) {
  lookout::testing::SpeckleImages images({}, 4);
  publish(images.next());
  images.next();  // Lost.
  core::SonarImage broken = images.next();
  broken.range_step = -1.0;
  publish(broken);
  publish(images.next());
  run();
  EXPECT_EQ(scans_.size(), 2U);
  EXPECT_EQ(node_.lost(), 1);
  EXPECT_EQ(node_.figures().rejected, 1);
  EXPECT_EQ(status_->dropped, 1);
}

TEST(DetectorNode, RefusesABadPrefix) {
  lcmtypes::Bus bus("memq://");
  EXPECT_THROW(DetectorNode(bus, "A B", {}, [](const std::string&) {}), core::InputError);
}

}  // namespace
}  // namespace lookout::tracking
