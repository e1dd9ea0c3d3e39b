// What comes of images and vehicle states through every fault that an image can have: received = used +
// rejected by reason, on either channel. Of scans tests/tools/experiments/tracking/faults_test.cpp asks it.
#include <gtest/gtest.h>

#include "lcmtypes/convert.hpp"
#include "lcmtypes/inbox.hpp"
#include "tests/tools/fault/fault_examples.hpp"
#include "tools/fault/wire_message.hpp"
#include "tracking/intake/scan_intake.hpp"

namespace lookout::tools {
namespace {

constexpr int kImages = 60;

/// An image of 2 beams and 3 bins as it travels; the content tells its number.
FaultMessage example_image(double seconds, std::int64_t sequence) {
  core::SonarImage image;
  image.utime = core::microseconds(seconds);
  image.sequence = sequence;
  image.bearings = {-0.1, 0.1};
  image.range_step = 1.0;
  image.first_range = 1.0;
  image.num_bins = 3;
  image.intensity = {1.0, 2.0, 3.0, 4.0, 5.0, 1.0 + static_cast<double>(sequence)};
  const sonar_image_t wire = lcmtypes::to_wire(image);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return {Stream::image, image.utime, {}, std::move(bytes), false};
}

/// Images and states through a plan, from bytes to an intake.
class AccountedImages {
 public:
  explicit AccountedImages(const std::string& faults)
      : line_(read_fault_plan("faults: [" + faults + "]", "plan"), 1,
              [this](const FaultMessage& message) { take(message); }) {
    inbox_.on<vehicle_state_t>("state", [this](const core::VehicleState& state) { intake_.add(state); });
    inbox_.on<sonar_image_t>("image", [this](core::SonarImage image) { intake_.add(std::move(image)); });
    for (int k = 0; k < kImages; ++k) {
      line_.take(example_state(0.5 * k - 0.1));
      line_.take(example_image(0.5 * k, k));
      line_.take(example_state(0.5 * k + 0.1));
    }
    line_.finish();
    intake_.finish();
  }

  void expect_accounted() const {
    const auto &images = inbox_.counts("image"), &states = inbox_.counts("state");
    const tracking::IntakeCounts& counts = intake_.counts();
    EXPECT_EQ(images.received, line_.counts(Stream::image).passed);
    EXPECT_EQ(images.received, bad(images) + counts.received);
    EXPECT_EQ(counts.received, counts.accepted + counts.rejected());
    EXPECT_EQ(states.received, line_.counts(Stream::vehicle).passed);
    EXPECT_EQ(states.received, bad(states) + counts.states);
    EXPECT_EQ(counts.states, counts.accepted_states + counts.bad_states);
  }
  const tracking::IntakeCounts& counts() const { return intake_.counts(); }

 private:
  void take(const FaultMessage& message) {
    const auto bytes = wire_bytes(message);
    inbox_.take(message.stream == Stream::image ? "image" : "state", bytes.data(), bytes.size());
  }
  static std::int64_t bad(const lcmtypes::ChannelCounts& counts) {
    return counts.undecodable + counts.refused + counts.handler_errors;
  }

  tracking::ImageIntake intake_{core::SonarParams(),
                                {[](const core::PosedImage&) {}, [] {}, [](const std::string&) {}}};
  lcmtypes::Inbox inbox_;
  FaultLine line_;
};

TEST(AccountedImages, EveryFaultOfAnImageLeavesNoMessageUnaccounted) {
  for (const char* fault :
       {"{kind: off, channel: image, from: 10, to: 20}", "{kind: garbage, channel: image, share: 0.5}",
        "{kind: delayed, channel: image, delay: 0.4}", "{kind: delayed, channel: image, delay: 3, to: 20}",
        "{kind: intermittent, channel: image, off: 2, on: 3}", "{kind: doubled, channel: image, share: 0.5}",
        "{kind: reordered, channel: image, share: 0.5}", "{kind: lost, channel: image, share: 0.3}",
        "{kind: flood, channel: image, copies: 20}",
        "{kind: flood, channel: image, copies: 20, content: garbage}",
        "{kind: clock_step, channel: vehicle, step: 3600, from: 10, to: 20}",
        "{kind: lost, channel: vehicle, share: 0.9}, {kind: reordered, channel: image, share: 0.5}"}) {
    SCOPED_TRACE(fault);
    AccountedImages(fault).expect_accounted();
  }
}

TEST(AccountedImages, WithoutAFaultAllAreUsed) {
  EXPECT_EQ(AccountedImages("{kind: off, channel: image, from: 100}").counts().accepted, kImages);
}

}  // namespace
}  // namespace lookout::tools
