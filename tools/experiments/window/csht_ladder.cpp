#include "tools/experiments/window/csht_ladder.hpp"

#include <stdexcept>
#include <utility>

#include "csht/baselines/csht_printed_estimator.hpp"
#include "csht/csht_estimator.hpp"
#include "csht/elements.hpp"
#include "csht/line_classes.hpp"
#include "csht/spatial_correlation.hpp"

namespace lookout::tools {
namespace {

constexpr double kNoTest = -1e9;  // Log evidence that every fit passes.

/// Rungs B and C: each class and the strongest east line of its gated detections is a target; no refit, no
/// test of the count.
class ClassesAsTargets : public csht::MotionEstimator {
 public:
  ClassesAsTargets(const csht::CshtParams& params, const core::SonarParams& sonar)
      : window_(params.window_scans, sonar, params.cross_floor),
        first_estimate_scans_(params.first_estimate_scans),
        votes_(space_of(params, sonar)),
        classes_(params.classes),
        correlation_(params.correlation, sonar.range_sigma,
                     csht::SingleLine(params.single_line, space_of(params, sonar))) {}

  std::span<const core::MotionElement> update(const core::PosedScan& scan) override {
    window_.add(scan);
    votes_.remove(window_.forgotten_lines(0));
    votes_.add(window_.newest_lines(0));
    elements_.clear();
    if (static_cast<int>(window_.scans().size()) < first_estimate_scans_) return elements_;
    const auto& pose = window_.scans().back().T_earth_sonar;
    const double epoch = window_.centre_time();
    lines_.clear();
    for (const auto& line : classes_.find(votes_, epoch, pose.north)) lines_.push_back(line);
    for (const auto& north : lines_) {
      const auto east =
          correlation_.second_lines(north, window_.lines(0), window_.lines(1), epoch, pose.east);
      if (!east.empty()) report(north, east.front(), epoch);
    }
    return elements_;
  }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::other; }
  int window_scans() const override { return static_cast<int>(window_.scans().size()); }
  int num_classes() const { return static_cast<int>(lines_.size()); }

 private:
  static csht::HoughSpace space_of(const csht::CshtParams& params, const core::SonarParams& sonar) {
    return {csht::csht_grid(params, sonar), params.votes, sonar.range_sigma, csht::largest_axis_sigma(sonar)};
  }

  void report(const csht::Line& north, const csht::Line& east, double epoch) {
    csht::Candidate target;
    target.state << north.intercept, east.intercept, north.velocity, east.velocity;
    target.covariance.setIdentity();
    elements_.push_back(csht::to_element(target, window_, epoch));
  }

  csht::HoughWindow window_;
  int first_estimate_scans_;
  csht::HoughSpace votes_;
  csht::LineClasses classes_;
  csht::SpatialCorrelation correlation_;
  std::vector<csht::Line> lines_;
  std::vector<core::MotionElement> elements_;
};

/// Rungs D to D2: one set, chosen for D on development seeds.
csht::CshtParams lower_rungs() {
  csht::CshtParams params = csht::CshtParams::window();
  params.intercept_step = 1.4;
  params.both_axes = false;
  params.passes = 1;
  params.votes.width = 1.5;
  params.classes.threshold = {0.4, 2.0, 2.0, 0.0};
  params.classes.isodata = {2.0, 0.4, 0.7, 0.3, 0.25, 1.0, 0.3};
  params.classes.max_first = 6;
  params.correlation = {1.5, 1, 3};
  params.single_line.peak_share = 0.9;
  params.refit.gate = 6.0;
  params.decision.min_evidence = kNoTest;
  params.decision.relative_support = 0.0;
  return params;
}

/// Rungs B and C, whose classes are targets: they must combine readily. The best of 432 sets on seed 1200,
/// light clutter, P_F = P_M = .1, .3, .5, .7, 16 windows each.
csht::CshtParams classes_alone(double peak_share) {
  csht::CshtParams params = lower_rungs();
  params.classes.threshold.peak_share = peak_share;
  params.classes.isodata.combination = 0.4;
  params.classes.isodata.deletion = 0.05;
  params.classes.isodata.aggregation = 0.8;
  return params;
}

csht::CshtParams with_plain_votes(csht::CshtParams params) {
  params.votes.fuzzy = false;
  params.votes.one_vote_a_scan = false;
  return params;
}

csht::CshtParams with_evidence(csht::CshtParams params, double relative_support) {
  const csht::CountDecisionParams full;
  params.decision.min_evidence = full.min_evidence;
  params.decision.relative_support = relative_support;
  return params;
}

csht::CshtParams with_first_classes(int most) {
  csht::CshtParams params = csht::CshtParams::window();
  params.classes.max_first = most;
  return params;
}

csht::CshtParams with_peaks_alone(int most) {
  csht::CshtParams params = csht::CshtParams::window();
  params.classes.cluster = false;
  params.classes.max_first = most;
  return params;
}

csht::CshtParams with_ready_combination() {
  csht::CshtParams params = csht::CshtParams::window();
  params.classes.isodata.combination = 0.3;
  return params;
}

LadderEstimator printed(bool own_time, int window_scans, const core::SonarParams& sonar) {
  csht::CshtPrintedParams params;
  params.own_time = own_time;
  params.window_scans = params.first_estimate_scans = window_scans;
  return {std::make_unique<csht::CshtPrintedEstimator>(params, sonar), {}};
}

LadderEstimator classes_as_targets(csht::CshtParams params, int window_scans,
                                   const core::SonarParams& sonar) {
  params.window_scans = params.first_estimate_scans = window_scans;
  auto estimator = std::make_unique<ClassesAsTargets>(params, sonar);
  const auto* told = estimator.get();
  return {std::move(estimator), [told] { return told->num_classes(); }};
}

LadderEstimator decided(csht::CshtParams params, int window_scans, const core::SonarParams& sonar) {
  params.window_scans = params.first_estimate_scans = window_scans;
  auto estimator = std::make_unique<csht::CshtEstimator>(params, sonar);
  estimator->keep_snapshots();
  const auto* told = estimator.get();
  return {std::move(estimator), [told] { return static_cast<int>(told->snapshot(0).classes.size()); }};
}

struct Rung {
  const char* name;
  std::function<LadderEstimator(int, const core::SonarParams&)> make;
};

/// A rung that decides the count with these parameters.
Rung rung(const char* name, const csht::CshtParams& params) {
  return {name,
          [params](int scans, const core::SonarParams& sonar) { return decided(params, scans, sonar); }};
}

std::vector<Rung> rungs() {
  const csht::CshtParams lower = lower_rungs(), full = csht::CshtParams::window();
  const double support = csht::CountDecisionParams().relative_support;
  return {{"A", [](int n, const auto& sonar) { return printed(false, n, sonar); }},
          {"A_time", [](int n, const auto& sonar) { return printed(true, n, sonar); }},
          {"B",
           [=](int n, const auto& sonar) {
             return classes_as_targets(with_plain_votes(classes_alone(0.4)), n, sonar);
           }},
          {"C", [=](int n, const auto& sonar) { return classes_as_targets(classes_alone(0.6), n, sonar); }},
          rung("D", lower),
          rung("D1", with_evidence(lower, 0.0)),
          rung("D2", with_evidence(lower, support)),
          rung("E", full),
          rung("E_peaks", with_peaks_alone(full.classes.max_first)),
          rung("E_peaks_40", with_peaks_alone(2 * full.classes.max_first)),
          rung("E_3", with_first_classes(3)),
          rung("E_6", with_first_classes(6)),
          rung("E_12", with_first_classes(12)),
          rung("E_combine", with_ready_combination())};
}

}  // namespace

std::vector<std::string> ladder_rungs() {
  std::vector<std::string> names;
  for (const auto& rung : rungs()) names.emplace_back(rung.name);
  return names;
}

LadderEstimator make_rung(const std::string& name, int window_scans, const core::SonarParams& sonar) {
  for (const auto& rung : rungs()) {
    if (rung.name == name) return rung.make(window_scans, sonar);
  }
  std::string accepted;
  for (const auto& known : ladder_rungs()) accepted.append(" ").append(known);
  throw std::invalid_argument("the rung must be one of" + accepted + ", got `" + name + "`");
}

}  // namespace lookout::tools
