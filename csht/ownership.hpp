#pragma once

#include <span>
#include <vector>

#include "csht/candidate.hpp"
#include "csht/count_decision.hpp"
#include "csht/hough_window.hpp"
#include "csht/refit.hpp"

namespace lookout::csht {

/// Gives every detection at most one owner: the best candidate is accepted first and takes its detections
/// away, those that shared them are fitted again to what is left. This merges duplicates and resolves
/// crossings.
class Ownership {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  Ownership(const RefitParams& refit, const CountDecisionParams& decision);

  /// Forgets the targets; all detections of the window are free.
  void start(const HoughWindow& window, double epoch);

  /// Refits the candidates and accepts them, the best first, until none is good enough. Overwrites them.
  /// @return how many were accepted.
  int accept(std::vector<Candidate>& candidates, const HoughWindow& window);

  /// In the order of acceptance; valid until the next `start`.
  std::span<const Candidate> accepted() const { return accepted_; }
  const std::vector<char>& free() const { return free_; }  ///< Per detection of the window.

 private:
  void refit_all(std::vector<Candidate>& candidates, const HoughWindow& window);
  void score_all(std::vector<Candidate>& candidates, const HoughWindow& window) const;
  /// The acceptable candidate with the most evidence; null where there is none.
  const Candidate* best(const std::vector<Candidate>& candidates) const;
  void take_detections(const Candidate& candidate, const HoughWindow& window);
  void refit_touched(std::vector<Candidate>& candidates, const HoughWindow& window);

  Refit refit_;
  CountDecision decision_;
  double epoch_ = 0.0;
  double num_free_ = 0.0;  ///< Free detections, each as much as the background makes of it.
  int best_support_ = 0;
  std::vector<char> free_;
  std::vector<Candidate> accepted_;
};

}  // namespace lookout::csht
