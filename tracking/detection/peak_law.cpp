#include "tracking/detection/peak_law.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

// Histogram of the logarithms of the peaks' ratios: lower end and width of a bin [nepers].
constexpr double kLowest = -3.0, kStep = 0.05;
constexpr std::size_t kNumBins = 240;
constexpr double kBase = 0.1;       // The law is fitted to this share of the peaks, the highest,
constexpr double kFirstCut = 3e-3;  // without this share, the very highest, while there is no threshold yet.
constexpr std::size_t kLeastBins = 8;
constexpr int kMaxSteps = 40;
constexpr double kEnough = 1e-8;       // A step that is smaller ends the fit.
constexpr double kLongest = 2.0;       // No step changes the logarithm of a count by more.
constexpr double kSteepest = -0.3;     // c1 where c2 = 0 is at most this: heavier than a K law of shape 0.03.
constexpr double kMostVariance = 2.0;  // Largest variance of a count's logarithm that corrects the threshold.
constexpr double kFixed = 1e12;        // Prior precision that holds a coefficient at its mean.

const Eigen::Vector4d kPriorMean(0.0, -1.0, -0.5, 0.0);       // Between Rayleigh and K of shape 1,
const Eigen::Vector4d kPriorPrecision(1e-9, 0.25, 4.0, 1.0);  // with room for both.

double log_ratio(std::size_t bin) {
  return kLowest + (static_cast<double>(bin) + 0.5) * kStep;
}

std::size_t bin_of(double log_ratio) {
  return static_cast<std::size_t>(std::clamp((log_ratio - kLowest) / kStep, 0.0, kNumBins - 1.0));
}

/// 1, sqrt(z), z, ln z at the middle of a bin.
Eigen::Vector4d terms(std::size_t bin) {
  const double root = std::exp(0.5 * log_ratio(bin));
  return {1.0, root, root * root, log_ratio(bin)};
}

}  // namespace

PeakLaw::PeakLaw(double memory_pings)
    : memory_pings_(memory_pings),
      counts_(kNumBins, 0.0),
      law_(kPriorMean),
      curvature_(kPriorPrecision.asDiagonal()) {
  core::require(memory_pings >= 1.0, "law memory_pings must be >= 1", memory_pings);
}

void PeakLaw::begin_ping() {
  const double fade = 1.0 - 1.0 / memory_pings_;
  for (double& count : counts_) count *= fade;
  total_ *= fade;
  pings_ = fade * pings_ + 1.0;
}

void PeakLaw::add(double ratio) {
  counts_[bin_of(std::log(std::max(ratio, std::numeric_limits<double>::min())))] += 1.0;
  total_ += 1.0;
}

double PeakLaw::threshold(double per_ping) {
  if (!(total_ > 0.0)) return std::numeric_limits<double>::infinity();
  const std::size_t first = first_below(kBase);
  const std::size_t last = std::max(cut_ > 0 ? cut_ : first_below(kFirstCut), first + kLeastBins);
  fit(first, std::min(last, kNumBins));
  const double wanted = per_ping * pings_;
  const double level = level_of(wanted);
  cut_ = bin_of(level);
  // The law is uncertain: the expected count is that of the mean law times exp(variance / 2), as of a
  // log-normal.
  const Eigen::Vector4d x = terms(cut_);
  const double variance = std::min(kMostVariance, x.dot(curvature_.ldlt().solve(x)));
  return std::exp(level_of(wanted * std::exp(-0.5 * variance)));
}

/// Logarithm of the ratio that, by the law, so many of the counted peaks reach or exceed.
double PeakLaw::level_of(double peaks) const {
  double above = 0.0;
  for (std::size_t bin = kNumBins; bin-- > 0;) {
    const double here = expected(bin);
    if (above + here >= peaks) return log_ratio(bin) + kStep * (0.5 - (peaks - above) / here);
    above += here;
  }
  return kLowest;
}

/// The lowest bin at or above which less than this share of the peaks lies.
std::size_t PeakLaw::first_below(double share) const {
  double above = 0.0;
  std::size_t bin = kNumBins;
  while (bin > 0 && above + counts_[bin - 1] < share * total_) above += counts_[--bin];
  return std::min(bin, kNumBins - kLeastBins);
}

/// Number of peaks that the law expects in a bin.
double PeakLaw::expected(std::size_t bin) const {
  return std::exp(law_.dot(terms(bin)) + log_ratio(bin)) * kStep;
}

void PeakLaw::fit(std::size_t first, std::size_t last) {
  double sum = 0.0, shape = 0.0;
  law_ = kPriorMean;
  for (std::size_t bin = first; bin < last; ++bin) {
    sum += counts_[bin];
    shape += expected(bin);
  }
  law_[0] = std::log(std::max(sum, 1.0) / shape);
  Eigen::Vector4d mean = kPriorMean, precision = kPriorPrecision;
  solve(first, last, mean, precision);
  if (law_[2] <= 0.0) return;
  mean[2] = 0.0;  // No exponential part: a stretched tail.
  precision[2] = kFixed;
  solve(first, last, mean, precision);
  if (law_[1] <= kSteepest) return;
  mean[1] = kSteepest;
  precision[1] = kFixed;
  solve(first, last, mean, precision);
}

/// Newton's method on the Poisson likelihood of the counts with a normal prior: concave, so that it climbs.
void PeakLaw::solve(std::size_t first, std::size_t last, const Eigen::Vector4d& mean,
                    const Eigen::Vector4d& precision) {
  for (int step = 0; step < kMaxSteps; ++step) {
    Eigen::Vector4d gradient = precision.cwiseProduct(mean - law_);
    curvature_ = precision.asDiagonal();
    for (std::size_t bin = first; bin < last; ++bin) {
      const Eigen::Vector4d x = terms(bin);
      const double here = expected(bin);
      gradient += (counts_[bin] - here) * x;
      curvature_ += here * x * x.transpose();
    }
    const Eigen::Vector4d change = curvature_.ldlt().solve(gradient);
    const double size = std::max(std::abs(change.dot(terms(first))), std::abs(change.dot(terms(last - 1))));
    law_ += change * std::min(1.0, kLongest / std::max(size, kEnough));
    if (change.cwiseAbs().maxCoeff() < kEnough) return;
  }
}

}  // namespace lookout::tracking
