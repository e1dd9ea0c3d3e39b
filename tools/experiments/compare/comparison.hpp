#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/experiments/compare/curve_score.hpp"
#include "tools/experiments/compare/paired_test.hpp"
#include "tools/experiments/harness/keyed_log.hpp"
#include "tools/experiments/harness/study.hpp"

namespace lookout::tools {

/// What a comparison is of; enough to report it where neither scenes nor methods are at hand.
struct ComparisonPlan {
  std::vector<std::string> scenes;   ///< Names.
  std::vector<std::string> methods;  ///< Labels.
  int runs = 0;                      ///< Of each method on each scene.
  CurveScoreParams score;            ///< What it is measured with.
  std::string reference = {};        ///< Method that all others are tested against; empty: each with each.
  std::string parameter = {};        ///< The methods are values of this parameter; empty: they are methods.
};

/// The key of a run in the log.
std::string run_key(const std::string& scene, const std::string& method, int run);

/// One run of method number `method` on scene number `scene`.
using MakeCurve = std::function<Curve(std::size_t scene, std::size_t method, int run)>;

/// Makes the runs of a comparison that belong to the shard and that the log has not, and logs them.
/// @param jobs threads, 0: all cores. `make` is called from several at once.
void run_comparison(const ComparisonPlan& plan, const Shard& shard, int jobs, const MakeCurve& make,
                    KeyedLog& log);

/// What all runs say of one column at one time.
struct CurvePoint {
  MeanInterval mean;  ///< Over the runs; of `nees` over all pairs, without an interval.
  NeesBounds bounds;  ///< Of `nees` alone: where the mean of consistent tracks lies in 95 % of all cases.
};

/// One method on one scene, all runs.
struct ComparedCell {
  std::string scene, method;
  std::array<std::vector<double>, kCurveColumns.size()> runs;  ///< The figure of each run, by column.
  std::map<std::int64_t, std::array<CurvePoint, kCurveColumns.size()>> over_time;  ///< By time [us].
  double nees_in_bounds =
      0.0;               ///< Share of times at which the mean NEES is within its bounds; NaN: no pairs.
  MeanInterval time_ms;  ///< Processor time of a scan [ms].
};

/// Called with each run in the order of scenes, methods and runs.
using OnCurve =
    std::function<void(const std::string& scene, const std::string& method, int run, const Curve&)>;

/// Reads all runs from a log, one at a time. @throws core::InputError where one is missing or damaged.
std::vector<ComparedCell> summarise(const ComparisonPlan& plan, const KeyedLog& log, const OnCurve& on_curve);

/// Two methods on one scene by one column.
struct ComparedPair {
  std::string scene, column, first, second;
  PairedTest test;
};

/// Tests of each pair of methods on each scene by each column that is tested, those without the reference
/// left out where there is one; their p corrected for the number of them all.
std::vector<ComparedPair> compare_pairs(const ComparisonPlan& plan, const std::vector<ComparedCell>& cells);

}  // namespace lookout::tools
