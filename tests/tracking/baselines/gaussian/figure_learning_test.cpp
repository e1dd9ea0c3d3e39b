#include "tracking/baselines/gaussian/figure_learning.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(FigureLearning, WhatIsGivenStays) {
  core::SonarParams sonar;
  sonar.miss_probability = 0.2;
  sonar.false_alarm_probability = 0.1;
  FigureLearning learning(sonar);
  for (int k = 0; k < 100; ++k) learning.learn({60.0, 90.0, 3.0, 0.5});
  EXPECT_DOUBLE_EQ(learning.figures().miss_probability, 0.2);
  EXPECT_DOUBLE_EQ(learning.figures().false_alarm_probability, 0.1);
}

TEST(FigureLearning, WhatIsNotGivenComesFromTheScans) {
  FigureLearning learning{core::SonarParams{}};
  for (int k = 0; k < 200; ++k) learning.learn({27.0, 90.0, 3.0, 1.5});
  EXPECT_NEAR(learning.figures().false_alarm_probability, 0.3, 0.001);  // 27 of 90 beams
  EXPECT_NEAR(learning.figures().miss_probability, 0.5, 0.01);          // 1.5 of 3 targets
}

TEST(FigureLearning, OneScanTellsTheFalseAlarms) {
  FigureLearning learning{core::SonarParams{}};
  learning.learn({63.0, 90.0, 0.0, 0.0});
  EXPECT_NEAR(learning.figures().false_alarm_probability, (63.0 + 0.8) / 94.0, 1e-3);  // with 4 trials at .2
}

}  // namespace
}  // namespace lookout::tracking
