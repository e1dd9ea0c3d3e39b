#include "core/files/parameter_list.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"

namespace lookout::core {
namespace {

struct Inner {
  int seeds = 24;
  bool soft = false;
};

struct Outer {
  double share = 0.5;
  std::optional<int> kept;
  Inner birth;
};

ParameterList list_of(Outer& p) {
  ParameterList list;
  list.add("share", p.share, {0.0, 1.0, true, true}, "Of all.");
  list.add("kept", p.kept, {1.0}, "Scans.");
  list.add("birth.seeds", p.birth.seeds, {1.0}, "Tried.");
  list.add("birth.soft", p.birth.soft, {}, "Or hard.");
  return list;
}

ParameterValues read(const std::string& text) {
  Outer outer;
  return list_of(outer).read(YamlMap::load_text(text, "test.yaml"));
}

std::string complaint(const std::string& text) {
  return testing::error_of([&] { read(text); });
}

TEST(ParameterList, ReadsNestedStructsAndSetsThem) {
  const ParameterValues values = read("{share: 0.25, birth: {seeds: 7, soft: true}, kept: 3}");
  Outer outer;
  list_of(outer).set(values);
  EXPECT_EQ(outer.share, 0.25);
  EXPECT_EQ(outer.kept, 3);
  EXPECT_EQ(outer.birth.seeds, 7);
  EXPECT_TRUE(outer.birth.soft);
}

TEST(ParameterList, WhatIsNotNamedStaysAsItIs) {
  EXPECT_TRUE(read("{}").empty());
  EXPECT_EQ(read("{birth: {seeds: 7}}").size(), 1U);
}

TEST(ParameterList, ErrorsNameLineKeyAndWhatIsAccepted) {
  EXPECT_NE(complaint("share: 1.0").find("expected a number in (0, 1)"), std::string::npos)
      << complaint("share: 1.0");
  EXPECT_NE(complaint("birth:\n  seeds: 0").find("test.yaml:2:"), std::string::npos);
  EXPECT_NE(complaint("birth: {sedes: 3}").find("sedes"), std::string::npos);
  EXPECT_NE(complaint("birth: {seeds: 1.5}"), "no error");
  EXPECT_NE(complaint("birth: {soft: 3}"), "no error");
  EXPECT_NE(complaint("shares: 0.5"), "no error");
}

TEST(ParameterList, SettingByPathChecksToo) {
  Outer outer;
  ParameterList list = list_of(outer);
  EXPECT_NE(testing::error_of([&] { list.set("birth.seeds", 0.0); }).find("expected a number >= 1"),
            std::string::npos);
  EXPECT_NE(testing::error_of([&] { list.set("birth.seeds", 1.5); }).find("a whole number"),
            std::string::npos);
  EXPECT_NE(testing::error_of([&] { list.set("birth.soft", 2.0); }), "no error");
  EXPECT_NE(testing::error_of([&] { list.set("birth.seed", 1.0); }).find("birth.seeds birth.soft"),
            std::string::npos);
  EXPECT_NE(testing::error_of([&] { list.set("share", 0.0 / 0.0); }), "no error");
}

TEST(ParameterList, ShowsItsValues) {
  Outer outer;
  const ParameterList list = list_of(outer);
  EXPECT_EQ(list.all()[0].present(), "0.5");
  EXPECT_EQ(list.all()[1].present(), "absent");
  EXPECT_EQ(list.all()[3].present(), "false");
  EXPECT_EQ(list.all()[2].kind(), "whole number");
  EXPECT_FALSE(list.all()[1].number());
}

TEST(Accepted, SaysWhatItHolds) {
  EXPECT_EQ((Accepted{0.0, 1.0, true, false}.text()), "in (0, 1]");
  EXPECT_EQ((Accepted{.low = 0.0, .open_low = true}.text()), "> 0");
  EXPECT_EQ((Accepted{.high = 0.0, .open_high = true}.text()), "< 0");
  EXPECT_EQ(Accepted{}.text(), "any number");
  EXPECT_FALSE((Accepted{0.0, 1.0, true, false}.holds(0.0)));
  EXPECT_TRUE((Accepted{0.0, 1.0, true, false}.holds(1.0)));
  EXPECT_FALSE(Accepted{}.holds(0.0 / 0.0));
}

}  // namespace
}  // namespace lookout::core
