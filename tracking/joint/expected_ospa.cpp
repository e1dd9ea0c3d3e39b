#include "tracking/joint/expected_ospa.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

constexpr std::size_t kPoolSize = 8192;
constexpr std::size_t kMostUndetected = 20;  // In one target set.

// Poisson draw by inversion of one uniform number.
std::size_t poisson(double mean, double uniform) {
  double term = std::exp(-mean);
  std::size_t count = 0;
  for (; uniform > term && count < kMostUndetected; ++count) {
    uniform -= term;
    term *= mean / static_cast<double>(count + 1);
  }
  return count;
}

}  // namespace

ExpectedOspa::ExpectedOspa(const ReportParams& params, core::Random& random) : params_(params) {
  uniform_.resize(kPoolSize);
  for (double& u : uniform_) u = random.uniform(0.0, 1.0);
}

std::size_t ExpectedOspa::choose(std::vector<ReportCandidate>& candidates, double undetected,
                                 core::Random& random) {
  std::sort(candidates.begin(), candidates.end(), [](const ReportCandidate& a, const ReportCandidate& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.slot < b.slot;
  });
  if (params_.report_all)
    return static_cast<std::size_t>(
        std::count_if(candidates.begin(), candidates.end(),
                      [this](const ReportCandidate& c) { return c.probability >= params_.min_existence; }));
  expected_.assign(candidates.size() + 1, 0.0);
  const std::size_t start = random();
  for (int sample = 0; sample < params_.samples; ++sample)
    add_sample(candidates, undetected, start + static_cast<std::size_t>(sample) * (candidates.size() + 1));
  return static_cast<std::size_t>(std::min_element(expected_.begin(), expected_.end()) - expected_.begin());
}

// Draws one target set, which candidates exist and how many undetected targets there are, and adds the OSPA
// of each number of reported candidates to the sums. [Schuhmacher2008] Eq. (3) with p = 2.
void ExpectedOspa::add_sample(std::span<const ReportCandidate> candidates, double undetected,
                              std::size_t start) {
  const auto draw = [&](std::size_t i) { return uniform_[(start + i) % kPoolSize]; };
  std::size_t targets = poisson(undetected, draw(candidates.size()));
  for (std::size_t i = 0; i < candidates.size(); ++i) targets += draw(i) < candidates[i].probability ? 1 : 0;
  const double limit = params_.cutoff * params_.cutoff;
  double localisation = 0.0;
  std::size_t matched = 0;
  for (std::size_t reported = 0; reported <= candidates.size(); ++reported) {
    const std::size_t larger = std::max(reported, targets);
    const double cost = localisation + limit * static_cast<double>(larger - matched);
    if (larger > 0) expected_[reported] += std::sqrt(cost / static_cast<double>(larger));
    if (reported < candidates.size() && draw(reported) < candidates[reported].probability) {
      localisation += std::min(limit, candidates[reported].variance);
      ++matched;
    }
  }
}

}  // namespace lookout::tracking
