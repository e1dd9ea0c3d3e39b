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

}  // namespace
}  // namespace lookout::core
