#include "fusion/track_association.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lookout::fusion {
namespace {

using States = std::vector<Eigen::Vector4d>;

AssociationParams printed() {
  AssociationParams params;
  params.rule = AssociationRule::max;
  return params;
}

TEST(TrackAssociation, MembershipFollowsTheThreeDistances) {
  const TrackAssociation association(printed());
  // 5 m, 1 m/s and 0 rad apart: 0.55/e + 0.35/e + 0.10, [Li2018] Eq. (11), (12).
  EXPECT_NEAR(association.membership({0, 0, 2, 0}, {5, 0, 3, 0}), 0.90 * std::exp(-1.0) + 0.10, 1e-12);
}

TEST(TrackAssociation, OppositeCoursesDiffer) {
  const TrackAssociation association(printed());
  // atan(y/x), as printed, would call these two equal; the membership loses 0.10 (1 - exp(-pi/0.8)).
  EXPECT_NEAR(association.membership({0, 0, 1, 1}, {0, 0, -1, -1}), 0.90 + 0.10 * std::exp(-M_PI / 0.8),
              1e-12);
}

TEST(TrackAssociation, HeadingWrapsAtHalfATurn) {
  const TrackAssociation association(printed());
  const double half = 0.01;  // Headings of 180 deg -+ 0.01 rad are 0.02 rad apart.
  const double mu = association.membership({0, 0, -std::cos(half), std::sin(half)},
                                           {0, 0, -std::cos(half), -std::sin(half)});
  EXPECT_NEAR(mu, 0.90 + 0.10 * std::exp(-2 * half / 0.8), 1e-12);
}

TEST(TrackAssociation, PrintedRuleTakesAnAlienAndStarvesATrack) {
  TrackAssociation association(printed());
  const States globals{{0, 0, 2, 0}, {12, 0, 2, 0}}, tracklets{{0, 0, 2, 0}, {5, 0, 2, 0}, {900, 0, -2, 0}};
  EXPECT_EQ(association.associate(tracklets, globals, {}), (std::vector<int>{0, 0, 0}));
}

TEST(TrackAssociation, RepairedRuleIsOneToOneAndRefusesTheAlien) {
  TrackAssociation association(AssociationParams{});
  const States globals{{0, 0, 2, 0}, {12, 0, 2, 0}}, tracklets{{0, 0, 2, 0}, {5, 0, 2, 0}, {900, 0, -9, 0}};
  EXPECT_EQ(association.associate(tracklets, globals, {}), (std::vector<int>{0, 1, -1}));
}

TEST(TrackAssociation, FarTargetsOfOneCourseAreTwo) {
  // 100 m apart at one velocity: 0.35 + 0.10 from speed and heading alone passes the threshold of 0.35.
  TrackAssociation as_printed(printed()), repaired(AssociationParams{});
  const States globals{{0, 0, 2, 0}}, tracklets{{100, 0, 2, 0}};
  EXPECT_NEAR(as_printed.membership(tracklets[0], globals[0]), 0.45, 1e-6);
  EXPECT_EQ(repaired.associate(tracklets, globals, {}), std::vector<int>{-1});
}

TEST(TrackAssociation, StandingTargetsHaveNoHeading) {
  const TrackAssociation association(AssociationParams{});
  // Two speeds of 0.02 m/s on opposite courses: noise, not a turn. Below 5 % of 1 m/s the term is dropped.
  EXPECT_NEAR(association.membership({0, 0, 0.02, 0}, {0, 0, -0.02, 0}), 1.0, 1e-12);
}

TEST(TrackAssociation, KeepsAPairWhereTargetsMeet) {
  TrackAssociation association(AssociationParams{});
  const States globals{{0, 0, 2, 0}, {0.4, 0, 2, 0}}, tracklets{{0.3, 0, 2, 0}, {0.1, 0, 2, 0}};
  EXPECT_EQ(association.associate(tracklets, globals, {}), (std::vector<int>{1, 0}));  // By distance alone.
  const std::vector<PastSupport> before{{0, false}, {1, false}};
  EXPECT_EQ(association.associate(tracklets, globals, before), (std::vector<int>{0, 1}));
}

TEST(TrackAssociation, AKeptPairNeedsTheGateAlone) {
  TrackAssociation association(AssociationParams{});
  // 7 m and 1.5 m/s off after a long wait: 0.55 e^-1.4 + 0.35 e^-1.5 + 0.1 = 0.31, short of 0.35.
  const States globals{{7, 0, 2.2, 0}}, tracklets{{0, 0, 0.7, 0}}, far{{20, 0, 2.2, 0}};
  const std::vector<PastSupport> before{{0, false}};
  EXPECT_EQ(association.associate(tracklets, globals, {}), std::vector<int>{-1});
  EXPECT_EQ(association.associate(tracklets, globals, before), std::vector<int>{0});
  EXPECT_EQ(association.associate(tracklets, far, before), std::vector<int>{-1});
}

TEST(TrackAssociation, ATrackOfOneVoiceStaysWithItWhateverComesNear) {
  TrackAssociation association(AssociationParams{});
  // Its own prediction is 8 m off, another's track stands where the tracklet is: the bonus of a shared track
  // does not make up for 0.55 (1 - e^-1.6).
  const States globals{{8, 0, 1, 0}, {0, 0, 1, 0}}, tracklets{{0, 0, 1, 0}};
  EXPECT_EQ(association.associate(tracklets, globals, std::vector<PastSupport>{{0, false}}),
            std::vector<int>{1});
  EXPECT_EQ(association.associate(tracklets, globals, std::vector<PastSupport>{{0, true}}),
            std::vector<int>{0});
}

TEST(TrackAssociation, NothingToAssociate) {
  TrackAssociation association(AssociationParams{});
  EXPECT_TRUE(association.associate({}, States{{0, 0, 1, 0}}, {}).empty());
  EXPECT_EQ(association.associate(States{{0, 0, 1, 0}}, {}, {}), std::vector<int>{-1});
}

TEST(TrackAssociation, RefusesBadParameters) {
  AssociationParams params;
  params.position_scale = 0.0;
  EXPECT_THROW(TrackAssociation{params}, std::invalid_argument);
  params = {};
  params.speed_weight = 0.5;  // The weights no longer sum to 1.
  EXPECT_THROW(TrackAssociation{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
