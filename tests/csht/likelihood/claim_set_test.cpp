#include "csht/likelihood/claim_set.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

ScanHistory two_scans(ClutterModel clutter) {
  ScanHistory history({.bearing_sigma = 0.01}, {.clutter = clutter}, 4);
  history.push(posed_scan({{core::radians(10.5), 80.0, 1}}, 0));
  history.push(posed_scan({{core::radians(0.5), 80.0, 1}, {core::radians(20.5), 30.0, 1}}, 1'000'000));
  return history;
}

Eigen::Vector4d at(double range, double bearing_deg) {
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  state.head<2>() = core::from_polar(range, core::radians(bearing_deg));
  return state;
}

TEST(ClaimSet, ClaimsTheBeamsOfTheSamples) {
  const ScanHistory history = two_scans(ClutterModel::exclusive_beam);
  ClaimSet claims;
  claims.clear(history, 2);
  EXPECT_EQ(claims.at_age(0), nullptr);
  const std::array<Eigen::Vector4d, 4> samples{at(80, 0.5), at(82, 0.5), at(81, 0.5), at(81, 1.5)};
  claims.claim(history, samples, 0.8);
  const BeamMask* mask = claims.at_age(0);
  ASSERT_NE(mask, nullptr);
  EXPECT_FLOAT_EQ(mask->share[46], 0.6F);  // Three of four samples, existence 0.8; slot = beam + 1.
  EXPECT_FLOAT_EQ(mask->share[47], 0.2F);
  EXPECT_NEAR(mask->range[46], 81.0, 1e-3);
  EXPECT_NE(claims.at_age(1), nullptr);  // At rest: there too.
  EXPECT_EQ(claims.at_age(2), nullptr);  // Outside the window.
}

TEST(ClaimSet, NothingOutsideTheField) {
  const ScanHistory history = two_scans(ClutterModel::exclusive_beam);
  ClaimSet claims;
  claims.clear(history, 2);
  claims.claim(history, std::array{at(80, 60.0), at(151, 0.5)}, 1.0);
  EXPECT_EQ(claims.at_age(0), nullptr);
}

TEST(ClaimSet, ClaimsTheReturnsOfAPointSensor) {
  const ScanHistory history = two_scans(ClutterModel::point);
  ClaimSet claims;
  claims.clear(history, 2);
  claims.claim(history, std::array{at(80, 0.5)}, 1.0);
  EXPECT_GT(claims.at_age(0)->share[0], 0.9F);
  EXPECT_LT(claims.at_age(0)->share[1], 0.01F);
}

}  // namespace
}  // namespace lookout::csht
