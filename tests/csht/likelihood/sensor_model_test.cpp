#include "csht/likelihood/sensor_model.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

TEST(SensorModel, TakesWhatTheSensorTells) {
  core::SonarParams params;
  params.miss_probability = 0.25;
  params.range_sigma = 2.0;
  const SensorFigures figures = figures_of(params);
  EXPECT_EQ(figures.miss_probability, 0.25);
  EXPECT_EQ(figures.range_sigma, 2.0);
  EXPECT_EQ(clutter_model_of(params), ClutterModel::exclusive_beam);
  params.clutter_per_scan = 4.0;
  EXPECT_EQ(clutter_model_of(params), ClutterModel::point);
}

TEST(SensorModel, NoFigureIsCertain) {
  core::SonarParams params;
  params.miss_probability = 0.0;
  params.false_alarm_probability = 1.0;
  const SensorFigures figures = figures_of(params);
  EXPECT_GT(figures.miss_probability, 0.0);
  EXPECT_LT(figures.false_alarm_probability, 1.0);
  EXPECT_NO_THROW(validate(figures));
}

}  // namespace
}  // namespace lookout::csht
