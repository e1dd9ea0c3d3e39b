#include "sonar_sim/return_selection.hpp"

#include <gtest/gtest.h>

namespace lookout::sonar_sim {
namespace {

BeamReturn heard(int beam, double range, double intensity, Source source) {
  return {beam, {0.1 * beam, range, intensity}, source};
}

/// One beam with a target behind a weak wall, and another with an alarm alone.
const std::vector<BeamReturn> kHeard{
    heard(3, 80.0, 5.0, Source::target), heard(3, 40.0, 2.0, Source::standing),
    heard(3, 60.0, 9.0, Source::background), heard(1, 70.0, 1.0, Source::background)};

double first_of_beam_3(int returns_per_beam, Keep keep) {
  for (const auto& one : select_returns(kHeard, returns_per_beam, keep))
    if (one.beam == 3) return one.measured.range;
  return 0.0;
}

TEST(ReturnSelection, EachRuleKeepsItsFirst) {
  EXPECT_EQ(first_of_beam_3(1, Keep::precedence), 80.0);  // the target
  EXPECT_EQ(first_of_beam_3(1, Keep::nearest), 40.0);     // the wall
  EXPECT_EQ(first_of_beam_3(1, Keep::strongest), 60.0);   // the alarm of intensity 9
}

TEST(ReturnSelection, KeepsAsManyABeamAsTheSonarReports) {
  EXPECT_EQ(select_returns(kHeard, 1, Keep::precedence).size(), 2u);
  EXPECT_EQ(select_returns(kHeard, 2, Keep::precedence).size(), 3u);
  EXPECT_EQ(select_returns(kHeard, 9, Keep::precedence).size(), 4u);
}

TEST(ReturnSelection, AScanListsReturnsByBearingThenRange) {
  const auto returns = in_order(kHeard);
  ASSERT_EQ(returns.size(), 4u);
  EXPECT_EQ(returns[0].range, 70.0);
  EXPECT_EQ(returns[1].range, 40.0);
  EXPECT_EQ(returns[3].range, 80.0);
}

}  // namespace
}  // namespace lookout::sonar_sim
