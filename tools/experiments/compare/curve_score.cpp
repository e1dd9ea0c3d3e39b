#include "tools/experiments/compare/curve_score.hpp"

#include <Eigen/Cholesky>
#include <limits>
#include <stdexcept>

#include "core/frames.hpp"
#include "tracking/metrics/ospa2.hpp"
#include "tracking/metrics/track_quality.hpp"
#include "tracking/metrics/trajectory_gospa.hpp"

namespace lookout::tools {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One run that is being measured, scan by scan.
class CurveScorer {
 public:
  CurveScorer(const CurveScoreParams& params)
      : params_(params),
        scorer_(params.ospa, params.kind),
        quality_({.gate = params.ospa.cutoff, .kind = params.kind}),
        ospa2_(params.ospa) {}

  void add(const core::GroundTruth& truth, const std::vector<core::Track>& tracks) {
    curve_.utime.push_back(truth.utime);
    add_distances(scorer_.add(truth, tracks));
    quality_.add(truth, tracks);
    add_quality(quality_.result());
    add_nees();
    add_trajectories(truth, tracks);
  }

  Curve finish() {
    add_trajectory_gospa();
    curve_.round();
    return std::move(curve_);
  }

 private:
  void push(const char* column, double value) { curve_[column].push_back(value); }

  void add_distances(const tracking::ScanScore& score) {
    push("ospa", score.position.total);
    push("ospa_localization", score.position.localization);
    push("ospa_cardinality", score.position.cardinality);
    push("velocity_ospa", score.velocity.total);
    push("gospa", score.gospa.total);
    push("gospa_localization", score.gospa.localization);
    push("gospa_missed", score.gospa.missed);
    push("gospa_false", score.gospa.false_tracks);
    push("num_targets", score.position.num_truth);
    push("num_tracks", score.position.num_tracks);
    push("count_correct", score.position.num_truth == score.position.num_tracks ? 1.0 : 0.0);
  }

  void add_quality(const tracking::TrackQualityResult& result) {
    push("time_to_confirm_s", result.targets.empty() ? kNone : result.time_to_confirm);
    push("false_per_100s", result.false_per_100s);
    push("identity_switches", result.identity_switches);
    push("followed_share", result.targets.empty() ? kNone : result.followed_share);
    push("purity", result.purity > 0.0 ? result.purity : kNone);
  }

  void add_nees() {
    double sum = 0.0;
    for (const auto& [target, track] : quality_.pairs()) {
      Eigen::Vector4d error;
      error << track.position() - target.position, track.velocity() - target.velocity;
      sum += error.dot(track.covariance.ldlt().solve(error)) / kNeesDimensions;
    }
    const auto pairs = static_cast<double>(quality_.pairs().size());
    push("nees", pairs > 0.0 ? sum / pairs : kNone);
    push("nees_pairs", pairs);
  }

  void add_trajectories(const core::GroundTruth& truth, const std::vector<core::Track>& tracks) {
    truth_.next_time();
    estimate_.next_time();
    for (const auto& target : truth.targets)
      if (tracking::counts(target, params_.kind)) truth_.add(target.id, target.position);
    for (const auto& track : tracks)
      if (tracking::counts(track, params_.kind)) estimate_.add(track.id, track.position());
    const std::int64_t begin = truth.utime - core::microseconds(params_.window);
    while (curve_.utime[window_begin_] <= begin) ++window_begin_;
    push("ospa2", ospa2_(truth_, estimate_, {window_begin_, curve_.utime.size() - 1}).total);
  }

  void add_trajectory_gospa() try {
    const tracking::TrajectoryGospa metric({params_.ospa.cutoff, params_.ospa.order, params_.switch_penalty});
    double switches = 0.0;
    for (const auto& step : metric(truth_, estimate_).steps) {
      push("tgospa", metric.total(step));
      push("tgospa_switches", switches += step.switches);
    }
  } catch (const std::length_error&) {  // Too many targets and tracks near one another for the exact metric.
    curve_["tgospa"].assign(curve_.utime.size(), kNone);
    curve_["tgospa_switches"].assign(curve_.utime.size(), kNone);
  }

  CurveScoreParams params_;
  tracking::Scorer scorer_;
  tracking::TrackQuality quality_;
  tracking::Ospa2 ospa2_;
  tracking::TrajectorySet truth_, estimate_;
  std::size_t window_begin_ = 0;  // The first scan of the window that ends at the newest.
  Curve curve_;
};

}  // namespace

Curve score_curve(const std::vector<core::GroundTruth>& truth,
                  const std::vector<std::vector<core::Track>>& tracks, const CurveScoreParams& params) {
  if (truth.size() != tracks.size()) throw std::invalid_argument("score_curve needs tracks for every scan");
  CurveScorer scorer(params);
  for (std::size_t k = 0; k < truth.size(); ++k) scorer.add(truth[k], tracks[k]);
  return scorer.finish();
}

}  // namespace lookout::tools
