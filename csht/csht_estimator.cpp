#include "csht/csht_estimator.hpp"

#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"
#include "csht/elements.hpp"

namespace lookout::csht {
namespace {

CshtParams completed(CshtParams params, const core::SonarParams& sonar) {
  core::require(params.window_scans >= 3 && params.window_scans <= kMaxWindowScans,
                "window_scans must be 3 to 100", params.window_scans);
  core::require(params.first_estimate_scans >= 1 && params.first_estimate_scans <= params.window_scans,
                "first_estimate_scans must be 1 to window_scans", params.first_estimate_scans);
  core::require(params.passes > 0, "passes must be > 0", params.passes);
  core::require(params.top_speed > 0.0, "top_speed must be > 0", params.top_speed);
  core::require_not_negative("speed_prior", params.speed_prior);
  params.refit.max_speed = params.top_speed * sonar.max_speed;
  params.refit.velocity_sigma = params.speed_prior * sonar.max_speed;
  params.decision.prior_speed = sonar.max_speed;
  params.decision.velocity_sigma = params.refit.velocity_sigma;
  return params;
}

HoughSpace make_space(const CshtParams& params, const core::SonarParams& sonar) {
  return {csht_grid(params, sonar), params.votes, sonar.range_sigma, largest_axis_sigma(sonar)};
}

}  // namespace

CshtEstimator::CshtEstimator(const CshtParams& params, const core::SonarParams& sonar)
    : params_(completed(params, sonar)),
      window_(params_.window_scans, sonar, params_.cross_floor),
      votes_{make_space(params_, sonar), make_space(params_, sonar)},
      free_votes_(make_space(params_, sonar)),
      classes_(params_.classes),
      correlation_(params_.correlation, sonar.range_sigma,
                   SingleLine(params_.single_line, make_space(params_, sonar))),
      ownership_(params_.refit, params_.decision) {}

std::span<const core::MotionElement> CshtEstimator::update(const core::PosedScan& scan) {
  window_.add(scan, clutter_);
  slide_votes();
  elements_.clear();
  if (static_cast<int>(window_.scans().size()) < params_.first_estimate_scans) return elements_;
  epoch_ = window_.centre_time();
  ownership_.start(window_, epoch_);
  for (int pass = 0; pass < params_.passes; ++pass) {
    gather_free_lines();
    candidates_.clear();
    if (pass == 0) propose_offered();
    propose(pass, 0);
    if (params_.both_axes) propose(pass, 1);
    if (ownership_.accept(candidates_, window_) == 0) break;
  }
  offered_.clear();
  report_elements();
  return elements_;
}

void CshtEstimator::offer(const Explained& explained) {
  clutter_ = explained.clutter;
  offered_.clear();
  for (const auto& track : explained.tracks) {
    Candidate candidate;
    candidate.state = track.state;
    candidate.offered = true;
    offered_.push_back(candidate);
  }
}

/// Adds the votes of the newest scan and removes those of the forgotten one; no other vote is touched.
void CshtEstimator::slide_votes() {
  for (const int axis : {0, 1}) {
    votes_[axis].remove(window_.forgotten_lines(axis));
    votes_[axis].add(window_.newest_lines(axis));
  }
}

/// The state of a track holds at the scan before the newest, that of a candidate at the epoch.
void CshtEstimator::propose_offered() {
  const auto scans = window_.scans();
  if (scans.size() < 2) return;
  for (const auto& offered : offered_) {
    candidates_.push_back(offered);
    candidates_.back().state.head<2>() = offered.position(epoch_ - scans[scans.size() - 2].time);
  }
}

void CshtEstimator::propose(int pass, int axis) {
  const HoughSpace& space = votes(pass, axis);
  const auto classes = classes_.find(space, epoch_, centre(axis));
  if (pass == 0 && keeps_snapshots_) take_snapshot(space, axis, classes);
  for (const Line& line : classes) add_candidates(line, axis);
}

const HoughSpace& CshtEstimator::votes(int pass, int axis) {
  if (pass == 0) return votes_[axis];
  free_votes_.clear();
  free_votes_.add(free_lines_[axis]);
  return free_votes_;
}

void CshtEstimator::add_candidates(const Line& line, int axis) {
  const int other = 1 - axis;
  for (const Line& second :
       correlation_.second_lines(line, free_lines_[axis], free_lines_[other], epoch_, centre(other))) {
    Candidate candidate;
    candidate.state[axis] = line.intercept;
    candidate.state[axis + 2] = line.velocity;
    candidate.state[other] = second.intercept;
    candidate.state[other + 2] = second.velocity;
    candidates_.push_back(candidate);
  }
}

void CshtEstimator::gather_free_lines() {
  for (const int axis : {0, 1}) {
    const auto lines = window_.lines(axis);
    free_lines_[axis].clear();
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (ownership_.free()[k]) free_lines_[axis].push_back(lines[k]);
    }
  }
}

/// Intercepts lie around the sonar.
double CshtEstimator::centre(int axis) const {
  const auto& pose = window_.scans().back().T_earth_sonar;
  return axis == 0 ? pose.north : pose.east;
}

void CshtEstimator::take_snapshot(const HoughSpace& space, int axis, std::span<const Line> classes) {
  VoteSnapshot& snapshot = snapshots_[axis];
  snapshot.grid = space.grid();
  snapshot.threshold = classes_.threshold();
  space.cells_above(0.0, epoch_, centre(axis), snapshot.cells);
  snapshot.classes.assign(classes.begin(), classes.end());
}

void CshtEstimator::report_elements() {
  for (const auto& target : ownership_.accepted()) {
    elements_.push_back(to_element(target, window_, epoch_));
    elements_.back().existence = existence_of(target, params_.decision);
  }
}

}  // namespace lookout::csht
