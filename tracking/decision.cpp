#include "tracking/decision.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

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

std::string evidence_text(const TrackDecision& decision) {
  constexpr std::size_t kLongest = 80;
  const auto& [hits, scans, misses] = decision.count;
  char text[kLongest];
  if (hits == 0)
    std::snprintf(text, sizeof text, "%.1f nats", decision.evidence);
  else if (misses == 0)
    std::snprintf(text, sizeof text, "supported in %d of %d scans", hits, scans);
  else
    std::snprintf(text, sizeof text, "supported in %d of %d scans, missed in %d since", hits, scans, misses);
  return text;
}

double log_odds(double existence) {
  constexpr double kLeast = std::numeric_limits<double>::epsilon();
  const double inside = std::clamp(existence, kLeast, 1.0 - kLeast);
  return std::log(inside / (1.0 - inside));
}

}  // namespace lookout::tracking
