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

/// Answers nothing; as if from outside the library.
class Silent final : public MotionEstimator {
 public:
  std::span<const core::MotionElement> update(const core::PosedScan&) override { return {}; }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::other; }
  int window_scans() const override { return 7; }
};

std::unique_ptr<MotionEstimator> make_silent(const EstimatorParams&, const core::SonarParams&,
                                             std::uint64_t) {
  return std::make_unique<Silent>();
}

TEST(RegisterEstimator, RefusesATakenNameABadOneAndNothing) {
  EXPECT_THROW(register_estimator("csht", &make_silent), std::invalid_argument);
  EXPECT_THROW(register_estimator("h_pmht", &make_silent), std::invalid_argument);
  EXPECT_THROW(register_estimator("two words", &make_silent), std::invalid_argument);
  EXPECT_THROW(register_estimator("", &make_silent), std::invalid_argument);
  EXPECT_THROW(register_estimator("none", nullptr), std::invalid_argument);
  EXPECT_EQ(estimator_names().size(), 5u);
}

// The last test here: what is registered stays.
TEST(RegisterEstimator, IsKnownToNamesToAConfigurationAndToItsMaker) {
  register_estimator("silent", &make_silent);
  EXPECT_EQ(estimator_names().back(), "silent");
  EXPECT_EQ(read("name: silent\n").name, "silent");
  EXPECT_EQ(make_estimator("silent", {}, {}, 1)->window_scans(), 7);
  EXPECT_THROW(register_estimator("silent", &make_silent), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
