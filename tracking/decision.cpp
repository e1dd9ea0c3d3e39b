#include "tracking/decision.hpp"

namespace lookout::tracking {

const char* to_string(DecisionKind kind) {
  switch (kind) {
    case DecisionKind::begin:
      return "begin";
    case DecisionKind::confirm:
      return "confirm";
    case DecisionKind::withdraw:
      return "withdraw";
    case DecisionKind::coast:
      return "coast";
    case DecisionKind::resume:
      return "resume";
    case DecisionKind::manoeuvre:
      return "manoeuvre";
    case DecisionKind::steady:
      return "steady";
    case DecisionKind::merge:
      return "merge";
    case DecisionKind::end:
      return "end";
  }
  return "unknown";
}

}  // namespace lookout::tracking
