#include "tools/experiments/compare/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lookout::tools {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Two scans; every column 1 and 3.
Curve two_scans() {
  Curve curve;
  curve.utime = {0, 500'000};
  for (auto& column : curve.values) column = {1.0, 3.0};
  return curve;
}

double reduced(const Curve& curve, const std::string& name) {
  return reduce(curve, column_index(name), 2.0);
}

TEST(Curve, EachColumnIsReducedInItsWay) {
  Curve curve = two_scans();
  EXPECT_DOUBLE_EQ(reduced(curve, "ospa"), 2.0);
  EXPECT_DOUBLE_EQ(reduced(curve, "identity_switches"), 3.0);
  EXPECT_DOUBLE_EQ(reduced(curve, "tgospa"), std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(reduced(curve, "nees"), (1.0 * 1.0 + 3.0 * 3.0) / 4.0);  // weighted by its pairs, 1 and 3
}

TEST(Curve, ScansWithoutAValueAreLeftOut) {
  Curve curve = two_scans();
  curve["ospa"][0] = kNone;
  curve["tgospa"] = {kNone, kNone};
  EXPECT_DOUBLE_EQ(reduced(curve, "ospa"), 3.0);
  EXPECT_TRUE(std::isnan(reduced(curve, "tgospa")));
}

TEST(Curve, ComesBackFromItsLine) {
  Curve curve = two_scans();
  curve.time_ms = 0.125;
  curve["nees"][1] = kNone;
  const auto back = curve_of(to_line("a key", curve));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, curve.utime);
  EXPECT_EQ(back->time_ms, 0.125);
  EXPECT_EQ((*back)["ospa"], curve["ospa"]);
  EXPECT_TRUE(std::isnan((*back)["nees"][1]));
}

TEST(Curve, DamagedLinesAreNone) {
  const std::string line = to_line("a key", two_scans());
  for (const std::string& text : {std::string(), std::string("3"), line.substr(0, line.size() / 2),
                                  std::string(R"({"time_ms":1,"utime":[0],"curve":{}})")})
    EXPECT_FALSE(curve_of(text)) << text;
}

TEST(Curve, RoundsToMicrometres) {
  Curve curve = two_scans();
  curve["ospa"][0] = 1.0 / 3.0;
  curve.round();
  EXPECT_EQ(curve["ospa"][0], 0.333333);
}

TEST(Curve, AnUnknownColumnIsAnError) {
  EXPECT_THROW(column_index("opsa"), std::out_of_range);
}

}  // namespace
}  // namespace lookout::tools
