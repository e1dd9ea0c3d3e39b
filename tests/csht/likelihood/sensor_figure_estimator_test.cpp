#include "csht/likelihood/sensor_figure_estimator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tests/csht/joint/noisy_scans.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

using testing::Course;
const Course kCourse{{80, 10}, {-0.4, 0.6}};

// 120 scans of one course, the target told, `clutter` false alarms in 90 beams and misses of 30 %.
SensorFigureEstimator watch(const core::SonarParams& given, int clutter, double sigma = 3.0,
                            int held_scans = 120, const Course& course = kCourse) {
  core::Random random(1011);
  const auto scans = testing::scans_of(
      {course}, 120, {.range_sigma = sigma, .quantise = true, .p_miss = 0.3, .clutter_per_scan = clutter},
      random);
  SensorFigureEstimator estimator({}, given);
  ScanHistory history(estimator.figures(), {}, 20);
  for (const auto& posed : scans) {
    history.push(posed);
    Eigen::Vector4d state;
    state << course.at(core::seconds(posed.scan.utime)), course.velocity;
    const std::array samples{state};
    const std::array targets{KnownTarget{samples, 1.0, held_scans}};
    estimator.update(history, targets);
    history.set_figures(estimator.figures());
  }
  return estimator;
}

TEST(SensorFigures, LearnsAllThree) {
  const auto estimate = watch(testing::sonar(), 20).estimate();
  // 20 draws over 90 beams fill 90 (1 - (89/90)^20) = 18.0 of them.
  EXPECT_NEAR(estimate.false_alarm_probability, 18.0 / 90.0, 4.0 * estimate.false_alarm_probability_sigma);
  // A beam with clutter before the missing target teaches nothing; 4 sigma of about 110 trials.
  EXPECT_NEAR(estimate.miss_probability, 0.3, 4.0 * estimate.miss_probability_sigma);
  EXPECT_NEAR(estimate.range_sigma, 3.0, 4.0 * estimate.range_sigma_sigma);
  EXPECT_LT(estimate.miss_probability_sigma, 0.06);
  EXPECT_LT(estimate.false_alarm_probability_sigma, 0.006);
}

// Where it was ten scans ago, the default `settle_scans`, is not known: nothing is learnt of returns and
// misses, and P_M stays where it is without any, 0.5 of four trials that have faded.
TEST(SensorFigures, ATargetThatHasNotBeenThereForLongTeachesNothing) {
  const auto estimate = watch(testing::sonar(), 20, 3.0, 9).estimate();
  EXPECT_DOUBLE_EQ(estimate.miss_probability, 0.5);
  EXPECT_GT(estimate.miss_probability_sigma, 0.2);
}

// Three sonars in turn, of which the first misses 30 %: its settled scan is the eleventh or twelfth before.
TEST(SensorFigures, OneOfSeveralSonarsLearnsFromItsOwnScans) {
  const Course course{{80, 10}, {-0.1, 0.1}};
  core::Random random(1012);
  const auto scans = testing::scans_of(
      {course}, 360, {.range_sigma = 3.0, .quantise = true, .p_miss = 0.3, .clutter_per_scan = 20}, random);
  SensorFigureEstimator estimator({}, testing::sonar());
  ScanHistory history(estimator.figures(), {}, 20);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    history.push(scans[k], static_cast<int>(k % 3));
    Eigen::Vector4d state;
    state << course.at(core::seconds(scans[k].scan.utime)), course.velocity;
    const std::array samples{state};
    const std::array targets{KnownTarget{samples, 1.0, 120}};
    if (k % 3 == 0) estimator.update(history, targets);
  }
  const auto estimate = estimator.estimate();
  EXPECT_NEAR(estimate.miss_probability, 0.3, 4.0 * estimate.miss_probability_sigma);
  EXPECT_LT(estimate.miss_probability_sigma, 0.06);  // Of 116 trials 0.043.
}

// At 149.5 m, 0.43 of the returns are beyond 150 m: a share of 0.6 of silences, and no more misses than
// anywhere.
TEST(SensorFigures, ReturnsLostBeyondTheRangeAreNoMisses) {
  const auto estimate = watch(testing::sonar(), 0, 3.0, 120, {{149.5, 1.0}, {0.0, 0.0}}).estimate();
  EXPECT_NEAR(estimate.miss_probability, 0.3, 0.15);  // Three sigma of 110 trials of which half tell little.
}

TEST(SensorFigures, RightFiguresAreUsedAsGiven) {
  core::SonarParams given = testing::sonar();
  given.miss_probability = 0.32;
  given.false_alarm_probability = 0.2;
  const auto estimator = watch(given, 20);
  EXPECT_FALSE(estimator.doubts_any());
  EXPECT_EQ(estimator.figures().miss_probability, 0.32);
  EXPECT_EQ(estimator.figures().false_alarm_probability, 0.2);
}

TEST(SensorFigures, WrongFiguresAreFoundOutAndReplaced) {
  core::SonarParams given = testing::sonar();
  given.miss_probability = 0.85;
  given.false_alarm_probability = 0.02;
  const auto estimator = watch(given, 20);
  EXPECT_TRUE(estimator.doubts_miss_probability());
  EXPECT_TRUE(estimator.doubts_false_alarm_probability());
  EXPECT_NEAR(estimator.figures().false_alarm_probability, 0.2, 0.03);
}

// A given P_M within the doubt of its own estimate, beside a P_F that ninety beams a scan contradict.
TEST(SensorFigures, AWrongFalseAlarmProbabilityCastsDoubtOnTheMisses) {
  core::SonarParams given = testing::sonar();
  given.miss_probability = 0.32;
  given.false_alarm_probability = 0.02;
  const auto estimator = watch(given, 20);
  EXPECT_FALSE(estimator.doubts_miss_probability());
  EXPECT_EQ(estimator.figures().miss_probability, estimator.estimate().miss_probability);
}

TEST(SensorFigures, AWrongRangeSigmaIsFoundOut) {
  const auto estimator = watch(testing::sonar(), 2, 1.2);  // 3 m is given.
  EXPECT_TRUE(estimator.doubts_range_sigma());
  // About 80 returns at 1.2 m and the given figure's weight of 20 at 3 m: sqrt((80 1.44 + 20 9) / 100) = 1.7.
  EXPECT_NEAR(estimator.figures().range_sigma, 1.7, 0.3);
}

// Ten scans of 45 returns each in 90 beams; then 36 of each turn out to be of a bottom.
TEST(SensorFigures, AScanThatIsPricedAnewCountsAsItIsPricedNow) {
  SensorFigureEstimator estimator({}, testing::sonar());
  ScanHistory history(estimator.figures(), {}, 20);
  std::vector<core::SonarReturn> returns;
  for (int beam = 0; beam < 90; beam += 2) returns.push_back({core::radians(-44.5 + beam), 100.0, 1});
  for (int k = 0; k < 10; ++k) {
    history.push(posed_scan(returns, 500'000L * k));
    estimator.update(history, {});
  }
  EXPECT_NEAR(estimator.estimate().false_alarm_probability, 0.5, 0.01);
  std::vector<float> background(history.newest().background.size(), 1.0F);
  for (std::size_t beam = 0; beam < 72; beam += 2) background[beam + 1] = 1e-3F;
  for (int age = 0; age < 10; ++age) history.set_background(age, background);
  history.push(posed_scan({returns.front()}, 5'000'000));
  estimator.update(history, {});
  // 9 returns in the 45 silent and 9 other beams of ten scans, one in 90 beams of the last.
  EXPECT_NEAR(estimator.estimate().false_alarm_probability, 91.0 / (540.0 + 90.0), 0.01);
}

// A return in every beam, in a scan that is known for a burst.
TEST(SensorFigures, ABurstTeachesNoFalseAlarms) {
  SensorFigureEstimator estimator({}, testing::sonar());
  ScanHistory history(estimator.figures(), {}, 20);
  std::vector<core::SonarReturn> all;
  all.reserve(90);
  for (int beam = 0; beam < 90; ++beam) all.push_back({core::radians(-44.5 + beam), 100.0, 1});
  for (int k = 0; k < 10; ++k) {
    history.push(posed_scan({all[0], all[10], all[20]}, 500'000L * k));
    estimator.update(history, {});
  }
  const double before = estimator.estimate().false_alarm_probability;
  history.push(posed_scan(all, 5'000'000));
  history.set_burst({1.0, 29.0});
  estimator.update(history, {});
  EXPECT_DOUBLE_EQ(estimator.estimate().false_alarm_probability, before);
}

// What the estimator learns of one sure target that stands at the ranges that `range_of` gives for each scan
// and returns with the errors of `error_of`, or not: nothing is asked of its other figures.
template <class Range, class Error>
SensorFigures taught(Range range_of, Error error_of, int scans) {
  SensorFigureEstimator estimator({.settle_scans = 1}, testing::sonar());
  ScanHistory history(estimator.figures(), {}, 20);
  Eigen::Vector4d before = Eigen::Vector4d::Zero();
  for (int k = 0; k < scans; ++k) {
    const Eigen::Vector4d state(range_of(k), 0.5, 0.0, 0.0);
    const std::optional<double> error = error_of(state[0]);
    std::vector<core::SonarReturn> returns;
    if (error) returns.push_back({core::radians(0.5), state[0] + *error, 1});
    history.push(posed_scan(returns, 500'000L * k));
    const std::array samples{k == 0 ? state : before};
    const std::array targets{KnownTarget{samples, 1.0, 120}};
    estimator.update(history, targets);
    history.set_figures(estimator.figures());
    before = state;
  }
  return estimator.figures();
}

// P_M is .1 near and .1 + .6 at the maximum range, in scans at 30 and 145 m by turns; of 400 trials the slope
// has an error of .04.
TEST(SensorFigures, LearnsThatRangeTakesEchoes) {
  core::Random random(71);
  const auto range_of = [](int k) { return k % 2 == 0 ? 30.0 : 145.0; };
  const auto figures = taught(
      range_of,
      [&](double range) -> std::optional<double> {
        if (random.bernoulli(0.1 + 0.6 * range * range / (150.0 * 150.0))) return std::nullopt;
        return random.gaussian(3.0);
      },
      400);
  EXPECT_NEAR(figures.range_loss, 0.6, 0.15);
  EXPECT_NEAR(figures.miss_probability, 0.1, 0.1);
}

TEST(SensorFigures, WithoutSuchALossNoneIsBelieved) {
  core::Random random(72);
  const auto range_of = [](int k) { return k % 2 == 0 ? 30.0 : 145.0; };
  const auto figures = taught(
      range_of,
      [&](double) -> std::optional<double> {
        if (random.bernoulli(0.3)) return std::nullopt;
        return random.gaussian(3.0);
      },
      400);
  EXPECT_EQ(figures.range_loss, 0.0);
  EXPECT_EQ(figures.tail_share, 0.0);
}

// Behind what hides it a target is never heard, near and far: P_M was learnt as 1, which no likelihood takes.
TEST(SensorFigures, AreInRangeWhereEachScanMisses) {
  const auto figures = taught([](int k) { return k % 2 == 0 ? 30.0 : 100.0; },
                              [](double) -> std::optional<double> { return std::nullopt; }, 400);
  EXPECT_NO_THROW(validate(figures));
  EXPECT_GT(figures.miss_probability, 0.95);
}

// A fifth of the returns have three times the error.
TEST(SensorFigures, LearnsThatErrorsHaveTails) {
  core::Random random(73);
  const auto figures = taught(
      [](int) { return 70.0; },
      [&](double) -> std::optional<double> { return random.gaussian(random.bernoulli(0.2) ? 9.0 : 3.0); },
      400);
  EXPECT_NEAR(figures.tail_share, 0.2, 0.12);
}

TEST(SensorFigures, CountsTheReturnsOfAPointSensor) {
  core::SonarParams given = testing::sonar();
  given.clutter_per_scan = 3.0;
  SensorFigureEstimator estimator({}, given);
  ScanHistory history(estimator.figures(), {.clutter = ClutterModel::point}, 20);
  for (const auto& posed : testing::noisy_scans({}, 50, 7, 1012)) {
    history.push(posed);
    estimator.update(history, {});
  }
  EXPECT_NEAR(estimator.estimate().false_alarm_probability * 90, 7.0, 0.1);
}

// P_M from 60 scans of a radar in which three targets made two returns, those of the first two; the third
// stood `apart` [m] behind the first.
double learnt_misses(double apart) {
  core::SonarParams radar = testing::sonar();
  radar.clutter_per_scan = 1.0;
  radar.resolution = 12.0;
  SensorFigureEstimator estimator({}, radar);
  ScanHistory history(estimator.figures(), {.clutter = ClutterModel::point}, 20);
  const std::array first{Eigen::Vector4d(60.0, 0.0, 0.0, 0.0)}, second{Eigen::Vector4d(20.0, 0.0, 0.0, 0.0)};
  const std::array third{Eigen::Vector4d(60.0 + apart, 0.0, 0.0, 0.0)};
  const std::array targets{KnownTarget{first, 1.0, 60}, KnownTarget{second, 1.0, 60},
                           KnownTarget{third, 1.0, 60}};
  for (int k = 0; k < 60; ++k) {
    history.push(posed_scan({{0.0, 60.0, 1}, {0.0, 20.0, 1}}, 500'000L * k));
    estimator.update(history, targets);
  }
  return estimator.estimate().miss_probability;
}

TEST(SensorFigures, OfTargetsNearerThanTheResolutionAMissTeachesNothing) {
  EXPECT_NEAR(learnt_misses(40.0), 1.0 / 3.0, 0.03);
  EXPECT_LT(learnt_misses(11.0), 0.05);  // The second, always heard, teaches alone.
}

TEST(SensorFigures, RefusesNonsense) {
  EXPECT_THROW(SensorFigureEstimator({.memory_scans = 0.5}, {}), std::invalid_argument);
  EXPECT_THROW(SensorFigureEstimator({.doubt_sigmas = 0.0}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
