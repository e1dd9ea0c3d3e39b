#include "core/parameter_check.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace lookout::core {
namespace {

std::string refusal(double value) {
  try {
    require_positive("step", value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterCheck, ShowsTheRuleAndTheValueAsWritten) {
  EXPECT_EQ(refusal(-1e-9), "step must be > 0 and finite, got -1e-09");
  EXPECT_EQ(refusal(0.0), "step must be > 0 and finite, got 0");
  EXPECT_EQ(refusal(1e-9), "");
}

TEST(ParameterCheck, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(nan), "");
  EXPECT_NE(refusal(std::numeric_limits<double>::infinity()), "");
  EXPECT_THROW(require_not_negative("step", nan), std::invalid_argument);
  EXPECT_NO_THROW(require_not_negative("step", 0.0));
}

TEST(ParameterCheck, KnowsWhichEndsOfAShareCount) {
  EXPECT_NO_THROW(require_probability("share", 0.0));
  EXPECT_NO_THROW(require_probability("share", 1.0));
  EXPECT_THROW(require_inner_share("share", 0.0), std::invalid_argument);
  EXPECT_THROW(require_inner_share("share", 1.0), std::invalid_argument);
  EXPECT_THROW(require_share("share", 0.0), std::invalid_argument);
  EXPECT_NO_THROW(require_share("share", 1.0));
  EXPECT_NO_THROW(require_share_below_one("share", 0.0));
  EXPECT_THROW(require_share_below_one("share", 1.0), std::invalid_argument);
}

TEST(ParameterCheck, RefusesSharesThatAreNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto check : {require_probability, require_inner_share, require_share, require_share_below_one})
    EXPECT_THROW(check("share", nan), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::core
