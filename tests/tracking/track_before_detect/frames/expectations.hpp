#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tracking/track_before_detect/frames/cell_expectation.hpp"

/// What the tests of the forms of the E-step share.
namespace lookout::tracking {

inline void expect_same(const Expectation& a, const Expectation& b, double relative) {
  const auto near = [relative](double x, double y, double scale) {
    EXPECT_NEAR(x, y, relative * std::max({std::abs(x), std::abs(y), scale, 1e-9}));
  };
  near(a.total_probability, b.total_probability, 0.0);
  near(a.total_intensity, b.total_intensity, 0.0);
  ASSERT_EQ(a.targets.size(), b.targets.size());
  for (std::size_t k = 0; k < a.targets.size(); ++k) {
    const double n = b.targets[k].responsibility;
    near(a.targets[k].responsibility, n, 0.0);
    near(a.targets[k].mass_inside, b.targets[k].mass_inside, 0.0);
    for (int i = 0; i < 2; ++i) {
      near(a.targets[k].first[i], b.targets[k].first[i], n);
      near(a.targets[k].second[i], b.targets[k].second[i], 0.0);
    }
  }
}

inline const std::vector<CellModel>& models() {
  static const std::vector<CellModel> kModels{
      {{31.7, 20.2}, {7.6, 7.6}, 0.5},   // on the target
      {{2.0, 38.0}, {4.0, 2.0}, 0.2},    // on a corner of cells near a corner of the frame
      {{33.0, 24.0}, {9.0, 12.0}, 0.1},  // overlapping the first
  };
  return kModels;
}

}  // namespace lookout::tracking
