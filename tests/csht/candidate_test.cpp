#include "csht/candidate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lookout::csht {
namespace {

TEST(Candidate, BeginsWithoutSamples) {
  const Candidate candidate;
  EXPECT_EQ(candidate.support, 0);
  EXPECT_TRUE(std::all_of(candidate.own.begin(), candidate.own.end(), [](int own) { return own == -1; }));
}

TEST(Candidate, MovesStraightAboutTheEpoch) {
  Candidate candidate;
  candidate.state << 10.0, 20.0, 1.0, -2.0;
  EXPECT_EQ(candidate.position(0.0), Eigen::Vector2d(10.0, 20.0));
  EXPECT_EQ(candidate.position(-3.0), Eigen::Vector2d(7.0, 26.0));
}

}  // namespace
}  // namespace lookout::csht
