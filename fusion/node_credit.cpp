#include "fusion/node_credit.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"

namespace lookout::fusion {

NodeCredit::NodeCredit(const NodeCreditParams& params, double trust) : params_(params), trust_(trust) {
  core::require_positive("prior_tracks", params.prior_tracks);
  core::require(params.memory >= 1.0, "memory must be >= 1", params.memory);
  core::require_probability("least", params.least);
  core::require_positive("proof", params.proof);
  core::require(params.max_unproved >= 1, "max_unproved must be >= 1", params.max_unproved);
}

// The mean of a beta density: the prior's tracks, and those that have an outcome.
double NodeCredit::of(std::int32_t node_id) const {
  const auto found = records_.find(node_id);
  if (found == records_.end()) return trust_;
  const auto& [proved, proved_false, unproved] = found->second;
  const double sum = params_.prior_tracks + proved + proved_false;
  return std::min(trust_, (params_.prior_tracks * trust_ + proved) / sum);
}

bool NodeCredit::may_begin(std::int32_t node_id, double life) const {
  if (life >= params_.proof) return true;
  const auto found = records_.find(node_id);
  return found == records_.end() ||
         (found->second.unproved < params_.max_unproved && of(node_id) >= params_.least);
}

/// Of more nodes than are kept the one with the fewest outcomes is forgotten.
NodeCredit::Record& NodeCredit::record(std::int32_t node_id) {
  if (records_.size() >= kMostNodes && !records_.contains(node_id)) {
    const auto outcomes = [](const auto& entry) { return entry.second.proved + entry.second.proved_false; };
    records_.erase(
        std::min_element(records_.begin(), records_.end(),
                         [&outcomes](const auto& a, const auto& b) { return outcomes(a) < outcomes(b); }));
  }
  return records_[node_id];
}

void NodeCredit::note_begun(std::int32_t node_id) {
  ++record(node_id).unproved;
}

void NodeCredit::note_proved(std::int32_t node_id) {
  settle(node_id, 1.0, 0.0);
}

void NodeCredit::note_false(std::int32_t node_id) {
  settle(node_id, 0.0, 1.0);
}

void NodeCredit::note_undecided(std::int32_t node_id) {
  settle(node_id, 0.0, 0.0);
}

void NodeCredit::settle(std::int32_t node_id, double proved, double proved_false) {
  Record& record = this->record(node_id);
  record.unproved = std::max(0, record.unproved - 1);
  const double sum = record.proved + record.proved_false;
  const double kept = sum >= params_.memory ? 1.0 - 1.0 / params_.memory : 1.0;
  record.proved = kept * record.proved + proved;
  record.proved_false = kept * record.proved_false + proved_false;
}

void NodeCredit::forget_unproved() {
  for (auto& [node_id, record] : records_) record.unproved = 0;
}

}  // namespace lookout::fusion
