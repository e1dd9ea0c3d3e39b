#include "csht/ownership.hpp"

#include <algorithm>

namespace lookout::csht {

Ownership::Ownership(const RefitParams& refit, const CountDecisionParams& decision)
    : refit_(refit), decision_(decision) {}

void Ownership::start(const HoughWindow& window, double epoch) {
  epoch_ = epoch;
  free_.assign(window.detections().size(), 1);
  num_free_ = 0.0;
  for (const auto& detection : window.detections()) num_free_ += detection.background;
  best_support_ = 0;
  accepted_.clear();
  decision_.prepare(window);
}

int Ownership::accept(std::vector<Candidate>& candidates, const HoughWindow& window) {
  int count = 0;
  refit_all(candidates, window);
  for (;;) {
    score_all(candidates, window);
    const Candidate* const winner = best(candidates);
    if (winner == nullptr) return count;
    accepted_.push_back(*winner);
    accepted_.back().offered = !decision_.accepts_as_new(*winner, best_support_);
    best_support_ = std::max(best_support_, winner->support);
    take_detections(accepted_.back(), window);
    refit_touched(candidates, window);
    ++count;
  }
}

void Ownership::refit_all(std::vector<Candidate>& candidates, const HoughWindow& window) {
  std::erase_if(candidates, [&](Candidate& c) { return !refit_.fit(c, window, epoch_, free_); });
}

void Ownership::score_all(std::vector<Candidate>& candidates, const HoughWindow& window) const {
  for (auto& candidate : candidates)
    candidate.log_evidence = decision_.log_evidence(candidate, window, epoch_, free_, num_free_);
}

const Candidate* Ownership::best(const std::vector<Candidate>& candidates) const {
  const Candidate* winner = nullptr;
  for (const auto& candidate : candidates) {
    if (!decision_.accepts(candidate, best_support_)) continue;
    if (winner == nullptr || candidate.log_evidence > winner->log_evidence) winner = &candidate;
  }
  return winner;
}

void Ownership::take_detections(const Candidate& candidate, const HoughWindow& window) {
  for (const int detection : candidate.own) {
    if (detection < 0) continue;
    free_[static_cast<std::size_t>(detection)] = 0;
    num_free_ -= window.detections()[static_cast<std::size_t>(detection)].background;
  }
}

void Ownership::refit_touched(std::vector<Candidate>& candidates, const HoughWindow& window) {
  std::erase_if(candidates, [&](Candidate& candidate) {
    const bool touched = std::any_of(candidate.own.begin(), candidate.own.end(), [&](int detection) {
      return detection >= 0 && !free_[static_cast<std::size_t>(detection)];
    });
    return touched && !refit_.fit(candidate, window, epoch_, free_);
  });
}

}  // namespace lookout::csht
