#include "tools/experiments/initiation/initiation_score.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tools {
namespace {

constexpr double kTrueShare = 0.75;  // Of a track's plots, or of the window's scans, from one target.
constexpr double kMostDiscrimination = 99.0;  // Where there is no false cell at all.

/// The target with most plots in a track, and how many.
struct Majority {
  int target = -1;
  int plots = 0;
};

Majority majority_of(const InitiationScene& scene, const TrackSources& track) {
  Majority best;
  for (int target = 0; target < scene.num_targets; ++target) {
    const auto plots = std::count_if(track.begin(), track.end(), [&](int source) {
      return scene.target_of[static_cast<std::size_t>(source)] == target;
    });
    if (plots > best.plots) best = {target, static_cast<int>(plots)};
  }
  return best;
}

bool is_true(const Majority& majority, std::size_t track_plots, int window_scans, TrueTrack reading) {
  const double plots = static_cast<double>(track_plots);
  if (reading == TrueTrack::share) return majority.plots >= kTrueShare * plots;
  if (reading == TrueTrack::lenient) return majority.plots > 0.5 * plots;
  return majority.plots >= std::ceil(kTrueShare * window_scans);
}

/// A cell as a line, seen from one target.
struct Offset {
  double lateral = 0.0;  ///< At the middle of the course [m].
  double angle = 0.0;    ///< To its direction [rad].
};

/// Seen from the middle of the course, so that both signs of a line agree.
Offset offset_from(const tracking::NormalLine& line, const Eigen::Vector2d& centre, double course_theta) {
  const tracking::NormalLine apart =
      tracking::line_difference({line.offset_of(centre), line.theta}, {0.0, course_theta});
  return {apart.rho, apart.theta};
}

/// A cell that belongs to a target.
struct TargetCell {
  Offset offset;
  double value = 0.0;
};

double spread_about_peak(const std::vector<TargetCell>& cells, const TargetCell& peak,
                         const AccumulatorScoreParams& params) {
  double sum = 0.0;
  int count = 0;
  for (const TargetCell& cell : cells) {
    if (cell.value <= 0.5 * peak.value) continue;
    const double lateral = (cell.offset.lateral - peak.offset.lateral) / params.rho_tolerance;
    const double angle = (cell.offset.angle - peak.offset.angle) / params.theta_tolerance;
    sum += lateral * lateral + angle * angle;
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

/// The cells of each target, and the strongest of none.
struct SortedCells {
  std::vector<std::vector<TargetCell>> of_target;
  double strongest_false = 0.0;
};

SortedCells sort_cells(const InitiationScene& scene, const tracking::HoughInitiator& method,
                       const AccumulatorScoreParams& params) {
  std::vector<tracking::LineVote> votes;
  method.append_cells(votes);
  SortedCells sorted;
  sorted.of_target.resize(static_cast<std::size_t>(scene.num_targets));
  const Eigen::Vector2d origin = method.grid_origin();
  std::vector<double> course_thetas;
  for (const auto& direction : scene.directions)
    course_thetas.push_back(tracking::line_through({0.0, 0.0}, direction)->theta);
  for (const tracking::LineVote& vote : votes) {
    tracking::NormalLine line = method.grid().centre(vote.cell);
    line.rho += origin.dot(line.normal());
    bool of_some_target = false;
    for (std::size_t i = 0; i < sorted.of_target.size(); ++i) {
      const Offset offset = offset_from(line, scene.centres[i], course_thetas[i]);
      if (std::abs(offset.lateral) > params.lateral_reach || std::abs(offset.angle) > params.angular_reach)
        continue;
      sorted.of_target[i].push_back({offset, vote.value});
      of_some_target = true;
    }
    if (!of_some_target) sorted.strongest_false = std::max(sorted.strongest_false, vote.value);
  }
  return sorted;
}

}  // namespace

TrackScore score_tracks(const InitiationScene& scene, const std::vector<TrackSources>& tracks,
                        int window_scans, TrueTrack reading) {
  TrackScore score;
  std::vector<bool> found(static_cast<std::size_t>(scene.num_targets), false);
  for (const TrackSources& track : tracks) {
    ++score.declared;
    const Majority majority = majority_of(scene, track);
    if (majority.target < 0 || !is_true(majority, track.size(), window_scans, reading)) {
      ++score.false_tracks;
    } else if (found[static_cast<std::size_t>(majority.target)]) {
      ++score.duplicates;
    } else {
      found[static_cast<std::size_t>(majority.target)] = true;
      ++score.targets_found;
    }
  }
  return score;
}

double surviving_share(const InitiationScene& scene, const std::vector<int>& survivors) {
  std::vector<bool> survives(scene.target_of.size(), false);
  for (const int source : survivors) survives[static_cast<std::size_t>(source)] = true;
  int plots = 0;
  int surviving = 0;
  for (std::size_t i = 0; i < survives.size(); ++i) {
    if (scene.target_of[i] < 0) continue;
    ++plots;
    surviving += survives[i] ? 1 : 0;
  }
  return plots > 0 ? 1.0 * surviving / plots : 0.0;
}

std::vector<int> sources_of(const tracking::PlotWindow& window, const std::vector<int>& plots) {
  std::vector<int> sources;
  for (const int plot : plots) sources.push_back(window.plot(plot).source);
  return sources;
}

std::vector<TrackSources> track_sources(const tracking::PlotWindow& window,
                                        const tracking::StartedTracks& started) {
  std::vector<TrackSources> tracks;
  for (const auto& track : started.tracks) {
    const auto plots = started.plots_of(track);
    tracks.push_back(sources_of(window, {plots.begin(), plots.end()}));
  }
  return tracks;
}

AccumulatorScore score_accumulator(const InitiationScene& scene, const tracking::HoughInitiator& method,
                                   const AccumulatorScoreParams& params) {
  const SortedCells sorted = sort_cells(scene, method, params);
  AccumulatorScore score;
  double weakest = std::numeric_limits<double>::infinity();
  for (const auto& cells : sorted.of_target) {
    TargetCell peak;
    for (const TargetCell& cell : cells) peak = cell.value > peak.value ? cell : peak;
    weakest = std::min(weakest, peak.value);
    score.divergence += spread_about_peak(cells, peak, params) / scene.num_targets;
    score.decline += (1.0 - peak.value / params.ideal) / scene.num_targets;
    score.found += (peak.value > sorted.strongest_false ? 1.0 : 0.0) / scene.num_targets;
  }
  score.discrimination = sorted.strongest_false > 0.0
                             ? std::min(kMostDiscrimination, weakest / sorted.strongest_false)
                             : kMostDiscrimination;
  return score;
}

}  // namespace lookout::tools
