#include "tracking/initiation/proposed_births.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

/// Proposes the same points, at rest, every scan.
class FixedProposals : public BirthMethod {
 public:
  explicit FixedProposals(const std::vector<Eigen::Vector2d>& points) {
    for (const auto& point : points) {
      core::MotionElement& element = elements_.emplace_back();
      element.position = point;
      element.existence = 0.7;
    }
  }
  std::span<const core::MotionElement> propose(const core::PosedScan& /*scan*/,
                                               std::span<const core::Track> /*tracks*/) override {
    return elements_;
  }

 private:
  std::vector<core::MotionElement> elements_;
};

// Ahead at 60 m; behind the sonar; ahead beyond the 150 m that it reaches.
TEST(BeginOnProposals, BeginsWhereTheSonarSees) {
  FixedProposals births({{60.0, 0.0}, {-60.0, 0.0}, {160.0, 0.0}});
  TrackBook book({});
  begin_on_proposals(births, scan_of(4, {}), core::SonarParams{}, book);
  ASSERT_EQ(book.tracks().size(), 1U);
  EXPECT_DOUBLE_EQ(book.tracks()[0].state[0], 60.0);
  EXPECT_DOUBLE_EQ(book.tracks()[0].existence, 0.7);
  EXPECT_EQ(book.tracks()[0].first_utime, 2'000'000);
}

}  // namespace
}  // namespace lookout::tracking
