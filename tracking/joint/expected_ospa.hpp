#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "tracking/joint/joint_params.hpp"

namespace lookout::tracking {

/// What the choice of the report needs to know of a track.
struct ReportCandidate {
  std::size_t slot = 0;      ///< Of the track.
  double probability = 0.0;  ///< That there is a target in view.
  double variance = 0.0;     ///< Mean squared position error if there is [m^2].
};

/// Chooses which tracks to report: the k most probable ones, with the k that makes the mean OSPA
/// ([Schuhmacher2008] Eq. (3), p = 2) least over target sets drawn from the candidates and from the
/// undetected targets. docs/joint_tracker.md.
class ExpectedOspa {
 public:
  /// @param params validated.
  ExpectedOspa(const ReportParams& params, core::Random& random);

  /// Sorts `candidates`, the most probable first.
  /// @param undetected mean number of targets in view that no candidate stands for.
  /// @return how many of them, from the front, to report.
  std::size_t choose(std::vector<ReportCandidate>& candidates, double undetected, core::Random& random);

 private:
  void add_sample(std::span<const ReportCandidate> candidates, double undetected, std::size_t start);

  ReportParams params_;
  std::vector<double> uniform_;   ///< Drawn once, used from a random place on.
  std::vector<double> expected_;  ///< Sum of OSPA over samples, by number reported.
};

}  // namespace lookout::tracking
