#include "tools/cli/scoring.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(MakeScorer, TakesCutoffAndTruthFromTheFlags) {
  Options options;
  options.cutoff = 8.0;
  options.truth = "schedule";
  tracking::Scorer scorer = make_scorer(options);
  EXPECT_EQ(scorer.kind(), tracking::TruthKind::schedule);
  core::GroundTruth truth;
  truth.targets.push_back({});
  EXPECT_EQ(scorer.add(truth, {}).position.total, 8.0);  // a target missed costs the cut-off
}

TEST(MakeScorer, RefusesWhatOspaDoesNotDefine) {
  Options options;
  options.cutoff = 0.0;
  EXPECT_THROW(make_scorer(options), core::InputError);
  options = {};
  options.order = 0.5;
  EXPECT_THROW(make_scorer(options), core::InputError);
  options = {};
  options.truth = "maybe";
  EXPECT_THROW(make_scorer(options), core::InputError);
}

TEST(Describe, NamesAllThreeParts) {
  tracking::OspaResult ospa;
  ospa.total = 1.8044;
  ospa.localization = 1.1404;
  ospa.cardinality = 1.39;
  EXPECT_EQ(describe(ospa), "OSPA 1.804 m (localization 1.140 m, cardinality 1.390 m)");
}

}  // namespace
}  // namespace lookout::tools
