#include "tracking/decision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace lookout::tracking {
namespace {

TEST(DecisionKind, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(DecisionKind::end); ++kind)
    names.insert(to_string(static_cast<DecisionKind>(kind)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(DecisionKind::end) + 1);
  EXPECT_EQ(names.count("unknown"), 0U);
  EXPECT_STREQ(to_string(DecisionKind::coast), "coast");
}

TEST(TrackDecision, RestsOnEvidenceOrOnCounts) {
  EXPECT_EQ(evidence_text({.evidence = 7.25}), "7.2 nats");
  EXPECT_EQ(evidence_text({.count = {.hits = 6, .scans = 9}}), "supported in 6 of 9 scans");
  EXPECT_EQ(evidence_text({.count = {.hits = 2, .scans = 9, .misses = 3}}),
            "supported in 2 of 9 scans, missed in 3 since");
}

TEST(TrackDecision, LogOddsStayFinite) {
  EXPECT_DOUBLE_EQ(log_odds(0.5), 0.0);
  EXPECT_NEAR(log_odds(0.9), std::log(9.0), 1e-12);
  EXPECT_NEAR(log_odds(1.0), 36.0, 0.1);  // -ln(2^-52)
  EXPECT_NEAR(log_odds(0.0), -36.0, 0.1);
}

}  // namespace
}  // namespace lookout::tracking
