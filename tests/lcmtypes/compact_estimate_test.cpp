#include "lcmtypes/compact_estimate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "core/frames.hpp"
#include "core/random.hpp"

namespace lookout::lcmtypes {
namespace {

using Limits = CompactLimits;

core::LocalEstimate any_estimate(core::Random& random) {
  core::LocalEstimate estimate;
  estimate.utime = core::microseconds(random.uniform(0.0, 1e9));
  estimate.node_id = static_cast<std::int32_t>(random.uniform(0.0, 255.0));
  estimate.track_id = static_cast<std::int64_t>(random.uniform(0.0, 65535.0));
  const auto place = [&](double reach) {
    return Eigen::Vector2d(random.uniform(-reach, reach), random.uniform(-reach, reach));
  };
  estimate.p_earth_node = place(1e6);
  estimate.state << estimate.p_earth_node + place(25e3), place(39.0);
  Eigen::Matrix4d root;
  for (double& own : root.reshaped()) own = random.gaussian(2.0);
  estimate.covariance = root * root.transpose() + 1e-3 * Eigen::Matrix4d::Identity();
  return estimate;
}

TEST(CompactEstimate, ComesBackWithinTheStatedErrors) {
  core::Random random(1001);
  for (int k = 0; k < 2000; ++k) {
    const core::LocalEstimate given = any_estimate(random);
    const auto packet = pack(given);
    ASSERT_TRUE(packet);
    const auto back = unpack(*packet, given.utime + core::microseconds(random.uniform(-8e3, 8e3)));
    ASSERT_TRUE(back);
    EXPECT_LE(std::abs(core::seconds(back->utime - given.utime)), Limits::kTimeError);
    EXPECT_EQ(back->node_id, given.node_id);
    EXPECT_EQ(back->track_id, given.track_id);
    EXPECT_LE((back->p_earth_node - given.p_earth_node).cwiseAbs().maxCoeff(), Limits::kNodeError);
    const Eigen::Vector4d error = (back->state - given.state).cwiseAbs();
    EXPECT_LE(error.head<2>().maxCoeff(), Limits::kPositionError);
    EXPECT_LE(error.tail<2>().maxCoeff(), Limits::kVelocityError);
    ASSERT_TRUE(back->covariance);
    for (int i = 0; i < 4; ++i) {
      const double sent = std::sqrt((*given.covariance)(i, i)), got = std::sqrt((*back->covariance)(i, i));
      EXPECT_NEAR(got / sent, 1.0, Limits::kSigmaError);
    }
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(*back->covariance).eigenvalues()(0), 0.0);
  }
}

TEST(CompactEstimate, FitsAnAcousticFrame) {
  EXPECT_LE(sizeof(CompactEstimate), 32u);
}

TEST(CompactEstimate, ACovarianceThatIsNotGivenIsNotThere) {
  core::LocalEstimate estimate;
  EXPECT_FALSE(unpack(*pack(estimate), 0)->covariance);
}

/// A CRC of 8 bits finds every single wrong bit.
TEST(CompactEstimate, ADamagedPacketIsRefused) {
  core::Random random(1002);
  const auto packet = pack(any_estimate(random));
  for (std::size_t bit = 0; bit < 8 * kCompactBytes; ++bit) {
    CompactEstimate damaged = *packet;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_FALSE(unpack(damaged, 0)) << bit;
  }
  EXPECT_FALSE(unpack(CompactEstimate{}, 0));
}

TEST(CompactEstimate, WhatDoesNotFitIsNotSent) {
  const auto with = [](auto change) {
    core::LocalEstimate estimate;
    change(estimate);
    return pack(estimate).has_value();
  };
  EXPECT_TRUE(with([](auto&) {}));
  EXPECT_FALSE(with([](auto& e) { e.state(0) = 27e3; }));
  EXPECT_FALSE(with([](auto& e) { e.state(2) = 41.0; }));
  EXPECT_FALSE(with([](auto& e) { e.state(3) = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_FALSE(with([](auto& e) { e.p_earth_node.x() = 1.1e6; }));
  EXPECT_FALSE(with([](auto& e) { e.node_id = 256; }));
  EXPECT_FALSE(with([](auto& e) { e.covariance = Eigen::Matrix4d::Zero(); }));
}

}  // namespace
}  // namespace lookout::lcmtypes
