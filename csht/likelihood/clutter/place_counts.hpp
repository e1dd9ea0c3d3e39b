#pragma once

#include <algorithm>
#include <cmath>

#include "csht/likelihood/clutter/clutter_density.hpp"
#include "csht/likelihood/clutter/point_bins.hpp"

namespace lookout::csht {

/// Returns around a place: all of them, and their shares that the other frame does not explain.
struct TwoCounts {
  double all = 0.0, free = 0.0;  ///< By their weights.
  /// Takes one in. @param kernel of its distance, >= 0.
  void take(const BinnedPoint& point, double kernel) {
    const double count = static_cast<double>(point.weight) * kernel;
    all += count;
    free += static_cast<double>(point.free) * count;
  }
};

/// What is dense at a place by either count.
struct TwoExcesses {
  Excess all, free;  ///< See TwoCounts.
};

/// The denser one of either.
inline TwoExcesses densest(const TwoExcesses& one, const TwoExcesses& other) {
  return {denser(one.all, other.all), denser(one.free, other.free)};
}

/// The kernel of all counts: a triangle of height 1 and half width 1.
template <class Real>
Real triangle(Real x) {
  return std::max(Real{0}, Real{1} - std::abs(x));
}

/// Its integral from -inf to x.
inline double triangle_below(double x) {
  const double c = std::clamp(x, -1.0, 1.0);
  return c < 0.0 ? 0.5 * (1.0 + c) * (1.0 + c) : 1.0 - 0.5 * (1.0 - c) * (1.0 - c);
}

/// A kernel's counts are no Poisson numbers: divided by the mean of its squares over its mean, their variance
/// equals their mean. Of a triangle that is 2/3, of a product of two 4/9.
inline constexpr double kKernelScale = 9.0 / 4.0;

}  // namespace lookout::csht
