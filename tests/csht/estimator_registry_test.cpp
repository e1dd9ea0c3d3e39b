#include "csht/estimator_registry.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"

namespace lookout::csht {
namespace {

EstimatorParams read(const std::string& text) {
  return testing::read_yaml(read_estimator_params, text);
}

TEST(EstimatorRegistry, ReadsTheWindowOfAConfiguration) {
  const auto params = read("window_scans: 40\nfirst_estimate_scans: 5\n");
  EXPECT_EQ(params.window_scans, 40);
  EXPECT_EQ(params.first_estimate_scans, 5);
}

TEST(EstimatorRegistry, RefusesUnknownKeysNamesAndWindows) {
  EXPECT_THROW(read("window: 40\n"), core::InputError);
  EXPECT_THROW(read("name: nonsense\n"), core::InputError);
  EXPECT_THROW(read("window_scans: 2\n"), core::InputError);
}

TEST(EstimatorRegistry, ShowsTheValueThatItRefuses) {
  EstimatorParams params;
  params.window_scans = 500;
  try {
    make_estimator("csht", params, {}, 1);
    FAIL() << "a window of 500 scans was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("500"), std::string::npos);
  }
  EXPECT_THROW(make_estimator("nonsense", {}, {}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
