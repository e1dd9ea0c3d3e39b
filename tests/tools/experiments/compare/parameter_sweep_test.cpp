#include "tools/experiments/compare/parameter_sweep.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"

namespace lookout::tools {
namespace {

Configuration with_tracker(const std::string& tracker) {
  Options options;
  options.tracker = tracker;
  return load_configuration(options);
}

std::string complaint(const std::string& text) {
  return testing::error_of([&] { parse_sweep(text, with_tracker("gnn")); });
}

TEST(ParameterSweep, ValuesAreEvenAndHoldThePresentOne) {
  const ParameterSweep sweep = parse_sweep("coast_s=4:8:3", with_tracker("gnn"));
  EXPECT_EQ(sweep.values, (std::vector<double>{4.0, 6.0, 8.0, 10.0}));  // 10 s is the default
  EXPECT_EQ(sweep.present, 10.0);
}

TEST(ParameterSweep, SevenValuesUnlessTold) {
  EXPECT_EQ(parse_sweep("gnn.gate_probability=0.9:0.99", with_tracker("gnn")).values.size(), 7U);
}

TEST(ParameterSweep, WholeParametersHaveWholeValuesOnce) {
  const ParameterSweep sweep = parse_sweep("gnn.life.confirm_hits=2:4:7", with_tracker("gnn"));
  EXPECT_EQ(sweep.values, (std::vector<double>{2.0, 3.0, 4.0, 6.0}));  // 6 is the tracker's own
}

TEST(ParameterSweep, ThePresentValueIsTheConfigurations) {
  Configuration configuration = with_tracker("gnn");
  configuration.tracker.own["gnn"]["gate_probability"] = 0.95;
  EXPECT_EQ(parse_sweep("gnn.gate_probability=0.9:0.99", configuration).present, 0.95);
}

TEST(ParameterSweep, RefusesOtherFormsAndValues) {
  for (const std::string text : {"coast_s", "coast_s=4", "coast_s=8:4", "coast_s=a:b", "coast_s=1:2:1",
                                 "coast_s=1:2:2.5", "coast_s=1:2:3:4", "coast_s=1:inf", "=1:2"})
    EXPECT_TRUE(complaint(text).starts_with("--parameter ")) << text << ": " << complaint(text);
  EXPECT_NE(complaint("gnn.gate_probability=0.5:1").find("expected a number in (0, 1)"), std::string::npos);
  EXPECT_NE(complaint("joint.birth.seeds=8:9").find("tracker gnn has no such parameter"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
