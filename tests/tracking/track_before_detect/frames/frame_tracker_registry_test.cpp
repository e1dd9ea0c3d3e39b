#include "tracking/track_before_detect/frames/frame_tracker_registry.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/support/reading.hpp"

namespace lookout::tracking {
namespace {

TbdParams read(const std::string& text) {
  return testing::read_yaml(read_tbd_params, text);
}

TEST(FrameTrackerRegistry, MakesEveryMethodItNames) {
  for (const std::string_view name : frame_tracker_names()) EXPECT_NE(make_frame_tracker(name, {}), nullptr);
  EXPECT_EQ(make_frame_tracker("h_pmht", {})->batch_length(), 5);
  EXPECT_EQ(make_frame_tracker("i_h_pmht_1", {})->batch_length(), 1);
  EXPECT_THROW(make_frame_tracker("kalman", {}), std::invalid_argument);
}

TEST(FrameTrackerRegistry, ReadsTheConfiguration) {
  const TbdParams params =
      read("{dct_db: 3.0, truncation: impute, polarity: dark, start: [120.0, 80.0, 2.5, 0.0]}");
  EXPECT_EQ(params.dct_db, 3.0);
  EXPECT_EQ(params.truncation, Truncation::impute);
  EXPECT_EQ(params.polarity, Polarity::dark);
  ASSERT_TRUE(params.start.has_value());
  EXPECT_EQ(*params.start, Eigen::Vector4d(120.0, 80.0, 2.5, 0.0));
  EXPECT_FALSE(read("{dct_db: 3.0}").start.has_value());
}

TEST(FrameTrackerRegistry, ReadsWhatIsKnownOfASonarsTargets) {
  const TbdParams params = read("{slowest: 0.1, birth_rate: 0.5, mark_time: 8.0}");
  EXPECT_EQ(params.slowest, 0.1);
  EXPECT_EQ(params.birth_rate, 0.5);
  EXPECT_EQ(params.mark_time, 8.0);
  EXPECT_THROW(read("{slowest: -0.1}"), core::InputError);
  EXPECT_THROW(read("{birth_rate: 0.0}"), core::InputError);
  EXPECT_THROW(read("{mark_time: -1.0}"), core::InputError);
}

TEST(FrameTrackerRegistry, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(read("{threshold: 3.0}"), core::InputError);
  EXPECT_THROW(read("{truncation: none}"), core::InputError);
  EXPECT_THROW(read("{start: [1.0, 2.0]}"), core::InputError);
  EXPECT_THROW(read("{target_area: 0.0}"), core::InputError);
}

}  // namespace
}  // namespace lookout::tracking
