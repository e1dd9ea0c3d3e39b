#include "tracking/management/life_decision.hpp"

namespace lookout::tracking {
namespace {

LifeDecision ended(const LifeStep& step, const LifeReasons& reasons) {
  const bool was_tentative = step.before == core::TrackStatus::tentative;
  if (was_tentative && !step.in_view) return {DecisionKind::end, "left the field of view unconfirmed"};
  if (was_tentative) return {DecisionKind::end, reasons.forget};
  return {DecisionKind::end, step.in_view ? reasons.end : reasons.lose};
}

}  // namespace

std::optional<LifeDecision> decided(const LifeStep& step, const LifeReasons& reasons) {
  if (step.ended) return ended(step, reasons);
  if (step.before == step.after) return std::nullopt;
  if (step.before == core::TrackStatus::tentative)
    return LifeDecision{DecisionKind::confirm, reasons.confirm};
  if (step.after == core::TrackStatus::coasting)
    return LifeDecision{DecisionKind::coast, "left the field of view"};
  return LifeDecision{DecisionKind::resume, "back in the field of view"};
}

}  // namespace lookout::tracking
