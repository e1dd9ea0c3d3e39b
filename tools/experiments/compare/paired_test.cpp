#include "tools/experiments/compare/paired_test.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace lookout::tools {
namespace {

constexpr double kTail = 0.025;  // On either side of an interval of 95 %.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double quantile_of_t(int degrees) {
  return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees), kTail));
}

double two_sided_p(double t, int degrees) {
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), std::abs(t)));
}

std::vector<double> differences(std::span<const double> first, std::span<const double> second) {
  std::vector<double> result(first.size());
  std::transform(first.begin(), first.end(), second.begin(), result.begin(), std::minus<>());
  return result;
}

/// Every difference is the same: certain if it is not 0.
PairedTest test_without_spread(PairedTest test) {
  const double infinity = std::numeric_limits<double>::infinity();
  test.t = test.effect = test.difference == 0.0 ? 0.0 : std::copysign(infinity, test.difference);
  test.p = test.difference == 0.0 ? 1.0 : 0.0;
  return test;
}

}  // namespace

void RunningMean::add(double value) {
  if (std::isnan(value)) return;
  ++count_;
  const double step = value - mean_;
  mean_ += step / count_;
  squares_ += step * (value - mean_);
}

MeanInterval RunningMean::result() const {
  if (count_ == 0) return {kNone, kNone, 0};
  if (count_ == 1) return {mean_, kNone, 1};
  const double error = std::sqrt(squares_ / (count_ - 1.0) / count_);
  return {mean_, quantile_of_t(count_ - 1) * error, count_};
}

MeanInterval mean_interval(std::span<const double> values) {
  RunningMean mean;
  for (const double value : values) mean.add(value);
  return mean.result();
}

PairedTest paired_test(std::span<const double> first, std::span<const double> second) {
  if (first.size() != second.size())
    throw std::invalid_argument("paired_test needs as many runs of either method");
  const MeanInterval mean = mean_interval(differences(first, second));
  PairedTest test{mean.count, mean.mean, mean.ci95, kNone, kNone};
  if (mean.count < 2) return test;
  if (mean.ci95 == 0.0) return test_without_spread(test);
  const double error = mean.ci95 / quantile_of_t(mean.count - 1);
  test.t = mean.mean / error;
  test.effect = test.t / std::sqrt(static_cast<double>(mean.count));
  test.p = two_sided_p(test.t, mean.count - 1);
  return test;
}

void correct_for_number(std::vector<PairedTest>& tests) {
  std::vector<std::size_t> order(tests.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tests[a].p < tests[b].p; });
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    PairedTest& test = tests[order[rank]];
    largest = std::max(largest, test.p * static_cast<double>(order.size() - rank));
    test.p_holm = std::min(1.0, largest);
  }
}

NeesBounds nees_bounds(double pairs, int dimensions) {
  const double degrees = pairs * dimensions;
  const boost::math::chi_squared distribution(degrees);
  return {boost::math::quantile(distribution, kTail) / degrees,
          boost::math::quantile(boost::math::complement(distribution, kTail)) / degrees};
}

}  // namespace lookout::tools
