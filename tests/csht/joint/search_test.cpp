#include "csht/joint/search.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include <algorithm>

#include "tests/csht/joint/joint_scenes.hpp"

namespace lookout::csht {
namespace {

using testing::Course;

const std::vector<Course> kCourses{{{80, 10}, {-1, 2}}, {{60, -30}, {2, 1}}};

JointSearchParams search_params() {
  JointSearchParams params;
  params.prior.max_speed = 5.0;
  return params;
}

std::vector<TargetHypothesis> search(const std::vector<core::PosedScan>& scans,
                                     const TargetHypothesis* known = nullptr) {
  ScanHistory history(testing::noisy_figures(), {}, 20);
  JointSearch search(search_params());
  core::Random random(1);
  std::vector<TargetHypothesis> found;
  for (const auto& scan : scans) {
    history.push(scan);
    ClaimSet claims;
    claims.clear(history, 20);
    if (known != nullptr) {
      TargetHypothesis target = *known;
      advance(core::seconds(scan.scan.utime), target);
      claims.claim(history, std::array{target.mean}, 1.0);
    }
    const auto targets = search.update(history, 20, claims, random);
    found.assign(targets.begin(), targets.end());
  }
  return found;
}

TEST(JointSearch, FindsAllTargets) {
  const auto found = search(testing::noisy_scans(kCourses, 20, 9, 1005));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_GT(found[0].existence(), 0.99);
}

// More than two go through the halves of the last decision; each keeps its own beams.
TEST(JointSearch, FindsFiveTargetsEachGivenTheOthers) {
  const std::vector<Course> five{{{80, 10}, {-1, 2}},
                                 {{60, -30}, {2, 1}},
                                 {{100, 50}, {0, -1}},
                                 {{40, 20}, {1, 1}},
                                 {{120, -40}, {-1, 0}}};
  const auto found = search(testing::noisy_scans(five, 20, 9, 1005));
  ASSERT_EQ(found.size(), 5u);
  for (const Course& course : five) {
    const bool there = std::any_of(found.begin(), found.end(), [&](const TargetHypothesis& target) {
      return (target.mean.head<2>() - course.at(9.5)).norm() < 6.0;  // two sigmas
    });
    EXPECT_TRUE(there) << course.position.transpose();
  }
}

// As a birth method: what a track explains is not found again.
TEST(JointSearch, LeavesOutWhatIsKnown) {
  TargetHypothesis known;
  known.mean << kCourses[0].position, kCourses[0].velocity;
  const auto found = search(testing::noisy_scans(kCourses, 20, 9, 1005), &known);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].mean.head<2>() - kCourses[1].at(9.5)).norm(), 6.0);
}

TEST(JointSearch, FindsNothingInClutter) {
  EXPECT_TRUE(search(testing::noisy_scans({}, 40, 9, 1006)).empty());
}

TEST(JointSearch, RefusesNonsense) {
  JointSearchParams no_pool, negative;
  no_pool.pool = 0;
  negative.second_look = -1.0;
  EXPECT_THROW(JointSearch{no_pool}, std::invalid_argument);
  EXPECT_THROW(JointSearch{negative}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
