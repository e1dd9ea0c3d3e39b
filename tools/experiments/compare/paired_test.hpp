#pragma once

#include <span>
#include <vector>

namespace lookout::tools {

/// Mean of values that are there (NaN: not there) and half the width of its interval.
struct MeanInterval {
  double mean = 0.0;  ///< NaN without values.
  double ci95 = 0.0;  ///< Half width of the 95 % interval by Student's t; NaN from less than two values.
  int count = 0;      ///< Values that are there.
};
/// @param values NaN: not there.
MeanInterval mean_interval(std::span<const double> values);

/// One value after another, for a mean and its interval in no memory [Welford1962].
class RunningMean {
 public:
  void add(double value);       ///< NaN: not there.
  MeanInterval result() const;  ///< Of the values added.

 private:
  int count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // Of the deviations from the mean.
};

/// Two methods on the same runs.
struct PairedTest {
  int runs = 0;             ///< In which both have a value.
  double difference = 0.0;  ///< Mean of first minus second, in the metric's unit.
  double ci95 = 0.0;        ///< Half width of its 95 % interval.
  double effect = 0.0;      ///< The mean difference over the standard deviation of the differences.
  double t = 0.0;           ///< The statistic, runs - 1 degrees of freedom.
  double p = 1.0;           ///< Two-sided; 1 where all differences are 0.
  double p_holm = 1.0;      ///< `p` corrected for all tests that are told together.
};

/// Student's t-test of the differences of two methods on common seeds.
/// @param first, second a value a run, of equal length; NaN: not there. @throws std::invalid_argument else.
/// @return p 1 and statistics of NaN where less than two runs have both.
PairedTest paired_test(std::span<const double> first, std::span<const double> second);

/// Corrects the p of all tests for their number, so that the chance of any false one stays at the level
/// [Holm1979].
void correct_for_number(std::vector<PairedTest>& tests);

/// Where the mean of `pairs` consistent NEES, each over its `dimensions`, lies in 95 % of all cases: it times
/// pairs x dimensions is chi-squared [BarShalom2001] 5.4.
struct NeesBounds {
  double low = 0.0;   ///< 2.5 % lie below.
  double high = 0.0;  ///< 2.5 % lie above.
};
/// @param pairs, dimensions > 0.
NeesBounds nees_bounds(double pairs, int dimensions);

}  // namespace lookout::tools
