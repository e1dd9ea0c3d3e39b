#include "core/files/time_text.hpp"

#include <gtest/gtest.h>

#include "core/frames.hpp"

namespace lookout::core {
namespace {

TEST(TimeText, PrintsMicrosecondsExactlyAndWithoutAnExponent) {
  EXPECT_EQ(time_text(107'438'450), "107.43845");  // seconds * 1e-6 as a double prints 107.43844999999999
  EXPECT_EQ(time_text(1'700'000'000'000'000), "1700000000");
  EXPECT_EQ(time_text(1'700'000'000'123'456), "1700000000.123456");
  EXPECT_EQ(time_text(0), "0");
  EXPECT_EQ(time_text(-1), "-0.000001");
  EXPECT_EQ(time_text(50'000), "0.05");
}

TEST(TimeText, ReadsBackEveryMicrosecond) {
  for (const std::int64_t utime : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, std::int64_t{999'999},
                                   std::int64_t{1'700'000'000'123'457}, kMaxUtime, -kMaxUtime})
    EXPECT_EQ(parse_time(time_text(utime)), utime);
}

TEST(TimeText, TakesOtherFormsAndRounds) {
  EXPECT_EQ(parse_time("1.7e+09"), 1'700'000'000'000'000);
  EXPECT_EQ(parse_time("+2.5"), 2'500'000);
  EXPECT_EQ(parse_time("0.0000005"), 1);  // to the nearest microsecond
  EXPECT_EQ(parse_time(".5"), 500'000);
}

TEST(TimeText, RefusesWhatIsNoTime) {
  for (const char* text : {"", "x", "1 s", "nan", "inf", "1e10", "1,5"})
    EXPECT_FALSE(parse_time(text)) << text;
}

TEST(TimeText, ResolutionIsThatOfTheLastDigit) {
  EXPECT_DOUBLE_EQ(stated_resolution("1.7e+09"), 1e8);
  EXPECT_DOUBLE_EQ(stated_resolution("0.250"), 1e-3);
  EXPECT_DOUBLE_EQ(stated_resolution("12"), 1.0);
}

}  // namespace
}  // namespace lookout::core
