#include "tracking/metrics/scorer.hpp"

#include <cmath>

namespace lookout::tracking {
namespace {

void accumulate(OspaResult& sum, const OspaResult& value) {
  sum.total += value.total;
  sum.localization += value.localization;
  sum.cardinality += value.cardinality;
}

void accumulate(GospaResult& sum, const GospaResult& value) {
  sum.total += value.total;
  sum.localization += value.localization;
  sum.missed += value.missed;
  sum.false_tracks += value.false_tracks;
}

OspaResult scaled(const OspaResult& sum, double factor, const OspaResult& newest) {
  return {sum.total * factor, sum.localization * factor, sum.cardinality * factor, newest.num_truth,
          newest.num_tracks};
}

GospaResult scaled(const GospaResult& sum, double factor, const GospaResult& newest) {
  return {sum.total * factor,        sum.localization * factor, sum.missed * factor,
          sum.false_tracks * factor, newest.num_missed,         newest.num_false};
}

}  // namespace

std::optional<TruthKind> truth_kind(std::string_view name) {
  if (name == "visible") return TruthKind::visible;
  if (name == "schedule") return TruthKind::schedule;
  return std::nullopt;
}

bool counts(const core::TargetTruth& target, TruthKind kind) {
  return kind == TruthKind::schedule || target.visible;
}

bool counts(const core::Track& track, TruthKind kind) {
  if (track.status == core::TrackStatus::confirmed) return true;
  return track.status == core::TrackStatus::coasting && kind == TruthKind::schedule;
}

Scorer::Scorer(const OspaParams& params, TruthKind kind) : kind_(kind), ospa_(params) {
  if (std::isfinite(params.order)) gospa_.emplace(params);
}

const ScanScore& Scorer::add(const core::GroundTruth& truth, std::span<const core::Track> tracks) {
  truth_position_.clear();
  truth_velocity_.clear();
  track_position_.clear();
  track_velocity_.clear();
  for (const core::TargetTruth& target : truth.targets) {
    if (!counts(target, kind_)) continue;
    truth_position_.push_back(target.position);
    truth_velocity_.push_back(target.velocity);
  }
  for (const core::Track& track : tracks) {
    if (!counts(track, kind_)) continue;
    track_position_.push_back(track.position());
    track_velocity_.push_back(track.velocity());
  }
  newest_.position = ospa_(truth_position_, track_position_);
  newest_.velocity = ospa_(truth_velocity_, track_velocity_);
  if (gospa_) newest_.gospa = (*gospa_)(truth_position_, track_position_);
  accumulate(sum_.position, newest_.position);
  accumulate(sum_.velocity, newest_.velocity);
  accumulate(sum_.gospa, newest_.gospa);
  ++num_scans_;
  return newest_;
}

ScanScore Scorer::mean() const {
  const double factor = num_scans_ > 0 ? 1.0 / num_scans_ : 0.0;
  return {scaled(sum_.position, factor, newest_.position), scaled(sum_.velocity, factor, newest_.velocity),
          scaled(sum_.gospa, factor, newest_.gospa)};
}

}  // namespace lookout::tracking
