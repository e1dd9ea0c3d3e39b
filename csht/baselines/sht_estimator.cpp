#include "csht/baselines/sht_estimator.hpp"

#include "core/parameter_check.hpp"
#include "csht/candidate.hpp"
#include "csht/elements.hpp"

namespace lookout::csht {
namespace {

HoughSpace make_space(const ShtParams& params, const core::SonarParams& sonar) {
  CshtParams csht = CshtParams::window();
  csht.window_scans = params.window_scans;
  csht.intercept_step = params.intercept_step;
  csht.velocity_step = params.velocity_step;
  VoteParams votes;
  votes.fuzzy = false;
  votes.one_vote_a_scan = false;
  return {csht_grid(csht, sonar), votes, sonar.range_sigma, sonar.range_sigma};
}

const ShtParams& validated(const ShtParams& params) {
  core::require(params.window_scans >= 3 && params.window_scans <= kMaxWindowScans,
                "window_scans must be 3 to 100", params.window_scans);
  core::require(params.intercept_step > 0.0, "intercept_step must be > 0", params.intercept_step);
  core::require(params.velocity_step > 0.0, "velocity_step must be > 0", params.velocity_step);
  core::require_inner_share("threshold", params.threshold);
  core::require_not_negative("apart", params.apart);
  core::require(params.max_targets >= 1, "max_targets must be > 0", params.max_targets);
  return params;
}

SpatialCorrelationParams strongest_line() {
  SpatialCorrelationParams params;
  params.max_lines = 1;
  return params;
}

}  // namespace

ShtEstimator::ShtEstimator(const ShtParams& params, const core::SonarParams& sonar)
    : params_(validated(params)),
      window_(params.window_scans, sonar, 0.0),
      north_votes_(make_space(params, sonar)),
      correlation_(strongest_line(), sonar.range_sigma, SingleLine({}, make_space(params, sonar))) {}

std::span<const core::MotionElement> ShtEstimator::update(const core::PosedScan& scan) {
  window_.add(scan);
  north_votes_.remove(window_.forgotten_lines(0));
  north_votes_.add(window_.newest_lines(0));
  elements_.clear();
  if (static_cast<int>(window_.scans().size()) < params_.first_estimate_scans) return elements_;
  epoch_ = window_.centre_time();
  find_peaks();
  for (const auto& peak : peaks_) report(peak);
  return elements_;
}

void ShtEstimator::find_peaks() {
  const double threshold = params_.threshold * north_votes_.statistics().peak;
  north_votes_.cells_above(threshold, epoch_, window_.scans().back().T_earth_sonar.north, cells_);
  sort_by_votes(cells_);
  strongest_apart(cells_, north_votes_.grid(), params_.apart, params_.max_targets, peaks_);
}

/// The covariance is that of a cell, and of one detection about the line: the method gives no other.
void ShtEstimator::report(const VoteCell& peak) {
  const Line north{peak.velocity, peak.intercept};
  const auto lines = correlation_.second_lines(north, window_.lines(0), window_.lines(1), epoch_,
                                               window_.scans().back().T_earth_sonar.east);
  if (lines.empty()) return;
  const HoughGrid& grid = north_votes_.grid();
  Candidate target;
  target.state << north.intercept, lines.front().intercept, north.velocity, lines.front().velocity;
  const double position = grid.intercept_step * grid.intercept_step;
  const double velocity = grid.velocity_step * grid.velocity_step;
  target.covariance.diagonal() << position, position, velocity, velocity;
  target.log_evidence = peak.votes;
  target.support = static_cast<int>(peak.votes);
  elements_.push_back(to_element(target, window_, epoch_));
}

}  // namespace lookout::csht
