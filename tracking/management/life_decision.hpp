#pragma once

#include <optional>

#include "core/track.hpp"
#include "tracking/decision.hpp"

namespace lookout::tracking {

/// What one scan made of a track's life.
struct LifeStep {
  core::TrackStatus before = core::TrackStatus::tentative;  ///< As the scan found it.
  core::TrackStatus after = core::TrackStatus::tentative;   ///< As the scan left it.
  bool in_view = true;                                      ///< Whether the sonar could see it.
  bool ended = false;                                       ///< Whether it is to be deleted.
};

/// Why a life confirms and ends a track, in its own terms; static texts.
struct LifeReasons {
  const char* confirm = "";  ///< A tentative track is confirmed.
  const char* forget = "";   ///< A tentative track in view ends.
  const char* end = "";      ///< A confirmed track in view ends.
  const char* lose = "";     ///< A track outside the field of view ends.
};

/// A decision and its reason, a static text.
struct LifeDecision {
  DecisionKind kind = DecisionKind::begin;  ///< What was decided.
  const char* reason = "";                  ///< Why.
};

/// What the scan decided about the track; nothing where it goes on as it was.
std::optional<LifeDecision> decided(const LifeStep& step, const LifeReasons& reasons);

}  // namespace lookout::tracking
