#include "tools/experiments/tracking/boat_score.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "core/frames.hpp"
#include "tools/experiments/harness/quantiles.hpp"
#include "tracking/metrics/ospa.hpp"

namespace lookout::tools {
namespace {

std::string suffix_of(std::int32_t id) {
  return "_target" + std::to_string(id);
}

double error_of(const tracking::TrackOnTarget& pair) {
  return (pair.track.position() - pair.target.position).norm();
}

bool confirmed(const std::vector<core::Track>& tracks, std::int64_t id) {
  return std::any_of(tracks.begin(), tracks.end(), [&](const core::Track& track) {
    return track.id == id && track.status == core::TrackStatus::confirmed;
  });
}

std::vector<Eigen::Vector2d> boats_in_sight(const core::GroundTruth& truth) {
  std::vector<Eigen::Vector2d> boats;
  for (const auto& target : truth.targets)
    if (target.visible) boats.push_back(target.position);
  return boats;
}

std::vector<Eigen::Vector2d> confirmed_near(const std::vector<core::Track>& tracks,
                                            const std::vector<Eigen::Vector2d>& boats, double reach) {
  std::vector<Eigen::Vector2d> near;
  for (const auto& track : tracks) {
    const bool counts = std::any_of(boats.begin(), boats.end(), [&](const Eigen::Vector2d& boat) {
      return (track.position() - boat).norm() <= reach;
    });
    if (counts && track.status == core::TrackStatus::confirmed) near.push_back(track.position());
  }
  return near;
}

// How long a boat has been silent, and the track that was on it when it fell silent.
struct Silence {
  int scans = 0;
  std::int64_t track = 0;
};

}  // namespace

bool heard_near(const core::PosedScan& scan, const Eigen::Vector2d& p_earth, double radius) {
  const auto& returns = scan.scan.returns;
  return std::any_of(returns.begin(), returns.end(), [&](const core::SonarReturn& sonar_return) {
    const auto p_sonar = core::from_polar(sonar_return.range, sonar_return.bearing);
    return (core::transform(scan.T_earth_sonar, p_sonar) - p_earth).norm() <= radius;
  });
}

Metrics follow_metrics(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                       const BoatScoreParams& params) {
  tracking::TrackQuality quality({.gate = params.gate});
  for (std::size_t k = 0; k < scans.size(); ++k) quality.add(scans[k].truth, tracks[k]);
  const auto result = quality.result();
  Metrics metrics{{"followed_share", result.followed_share},
                  {"identities", result.identities},
                  {"identity_switches", result.identity_switches},
                  {"mean_tracks", result.mean_tracks}};
  for (const auto& target : result.targets) {
    const std::string suffix = suffix_of(target.id);
    metrics["followed_share" + suffix] = target.followed_share();
    metrics["identities" + suffix] = target.identities;
    if (target.median_error) metrics["median_error_m" + suffix] = *target.median_error;
  }
  return metrics;
}

double ospa_near(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                 const BoatScoreParams& params) {
  tracking::Ospa ospa;
  double sum = 0.0;
  int counted = 0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const auto boats = boats_in_sight(scans[k].truth);
    if (boats.empty()) continue;
    sum += ospa(boats, confirmed_near(tracks[k], boats, params.reach)).total;
    ++counted;
  }
  return sum / std::max(counted, 1);
}

Metrics excess_errors(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                      const TracksOfScans& rival, const BoatScoreParams& params) {
  tracking::TrackQuality own({.gate = params.gate}), other({.gate = params.gate});
  std::map<std::int32_t, std::pair<std::vector<double>, std::vector<double>>> errors;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    own.add(scans[k].truth, tracks[k]);
    other.add(scans[k].truth, rival[k]);
    for (const auto& pair : own.pairs())
      for (const auto& rivals : other.pairs()) {
        if (pair.target.id != rivals.target.id) continue;
        errors[pair.target.id].first.push_back(error_of(pair));
        errors[pair.target.id].second.push_back(error_of(rivals));
      }
  }
  Metrics metrics;
  double sum = 0.0;
  for (const auto& [id, both] : errors) {
    const double excess = median(both.first) - median(both.second);
    metrics["excess_error_m" + suffix_of(id)] = excess;
    sum += excess;
  }
  if (!errors.empty()) metrics["excess_error_m"] = sum / static_cast<double>(errors.size());
  return metrics;
}

Metrics silences(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                 const BoatScoreParams& params) {
  tracking::TrackQuality quality({.gate = params.gate});
  std::map<std::int32_t, Silence> silent;
  std::map<std::int32_t, std::int64_t> on;  // The track on a boat at the scan before.
  int count = 0, kept = 0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for (const auto& target : scans[k].truth.targets) {
      Silence& silence = silent[target.id];
      const bool heard = heard_near(scans[k].posed, target.position, params.radius);
      if (heard || !target.visible) {
        silence = {};
        continue;
      }
      if (silence.scans++ == 0) silence.track = on.contains(target.id) ? on[target.id] : 0;
      if (silence.scans != params.silent_scans || silence.track == 0) continue;
      ++count;
      kept += confirmed(tracks[k], silence.track) ? 1 : 0;
    }
    quality.add(scans[k].truth, tracks[k]);
    on.clear();
    for (const auto& pair : quality.pairs()) on[pair.target.id] = pair.track.id;
  }
  Metrics metrics{{"silences", count}};
  if (count > 0) metrics["silence_kept_share"] = Metric(static_cast<double>(kept) / count, count);
  return metrics;
}

}  // namespace lookout::tools
