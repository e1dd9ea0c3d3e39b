#include "tools/experiments/tracking/sensor_knowledge.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tools {
namespace {

constexpr SceneVariant kVariant{0.3, 0.1, 3.0, sonar_sim::ClutterReading::literal};

core::SonarParams told(const std::string& figures) {
  return told_params(load_variant("tracking_table7.yaml", kVariant), kVariant, figures, 1000, 0);
}

double odds(double p) {
  return p / (1.0 - p);
}

TEST(ToldParams, KnownAreTheScenes) {
  EXPECT_EQ(told("known").false_alarm_probability, 0.3);
  EXPECT_EQ(told("known").miss_probability, 0.1);
}

TEST(ToldParams, HalfAndDoubleAreOfTheOdds) {
  for (const auto& [name, factor] : {std::pair{"half", 0.5}, std::pair{"double", 2.0}}) {
    const auto sonar = told(name);
    EXPECT_NEAR(odds(*sonar.false_alarm_probability), factor * odds(0.3), 1e-12);
    EXPECT_NEAR(odds(*sonar.miss_probability), factor * odds(0.1), 1e-12);
    EXPECT_EQ(sonar.range_sigma, 3.0);
  }
}

TEST(ToldParams, UnknownAreLearntFromAHundredScans) {
  const auto sonar = told("unknown");
  // 9,000 beam looks: one standard deviation of P_F is .005. Some 330 looks at targets: of P_M .017; the
  // estimator's own mistakes about which detection is whose come on top.
  EXPECT_NEAR(*sonar.false_alarm_probability, 0.3, 0.02);
  EXPECT_NEAR(*sonar.miss_probability, 0.1, 0.07);
  EXPECT_NE(*sonar.false_alarm_probability, 0.3);  // learnt, not copied
}

TEST(ToldParams, RefusesAnotherWord) {
  EXPECT_THROW(told("guessed"), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
