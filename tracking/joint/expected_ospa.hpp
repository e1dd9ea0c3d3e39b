#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "tracking/joint/joint_params.hpp"

namespace lookout::tracking {

/// A track as the report weighs it.
struct ReportCandidate {
  std::size_t slot = 0;
  double probability = 0.0;  ///< That there is a target in view.
  double variance = 0.0;     ///< Mean squared position error if there is [m^2].
};

/// Chooses which tracks to report: the most probable k, k such that the expected OSPA over target sets drawn
/// from the candidates (and from targets not seen yet) is least. docs/joint_tracker.md.
class ExpectedOspa {
 public:
  /// @throws nothing; `params` are validated by the tracker.
  ExpectedOspa(const ReportParams& params, core::Random& random);

  /// @param candidates are sorted, the most probable first.
  /// @param unseen mean number of targets in view that no candidate stands for.
  /// @return how many of them, from the front, to report.
  std::size_t choose(std::vector<ReportCandidate>& candidates, double unseen, core::Random& random);

 private:
  void add_sample(std::span<const ReportCandidate> candidates, double unseen, std::size_t start);

  ReportParams params_;
  std::vector<double> uniform_;   ///< Drawn once, used from a random place on.
  std::vector<double> expected_;  ///< Sum of OSPA over samples, by number reported.
};

}  // namespace lookout::tracking
