#include "tracking/detection/one_return.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lookout::tracking {
namespace {

float power_ratio(double decibel) {
  return static_cast<float>(std::pow(10.0, decibel / 10.0));
}

/// Decides of two peaks whether they are one echo.
class EchoRule {
 public:
  EchoRule(const ImagePlane& plane, const EchoExtent& extent, const EchoParams& params)
      : plane_(plane),
        extent_(extent),
        valley_(power_ratio(-params.valley_db)),
        sidelobe_(power_ratio(params.sidelobe_db)) {}

  bool one_echo(const PlanePeak& strong, const PlanePeak& weak) const {
    return is_sidelobe(strong, weak) || !has_valley(strong, weak);
  }

 private:
  /// The pattern's envelope falls with the square of the distance from the axis, as a line array's does.
  bool is_sidelobe(const PlanePeak& strong, const PlanePeak& weak) const {
    if (std::abs(strong.bin - weak.bin) > std::lround(extent_.bins)) return false;
    const double widths = std::max(1.0, std::abs(strong.beam - weak.beam) / extent_.beams);
    return static_cast<double>(weak.value) * widths * widths < static_cast<double>(sidelobe_ * strong.value);
  }

  /// Whether the cells on the straight line between them fall low enough.
  bool has_valley(const PlanePeak& a, const PlanePeak& b) const {
    const int beams = b.beam - a.beam, bins = b.bin - a.bin;
    const int steps = std::max(std::abs(beams), std::abs(bins));
    const float low = valley_ * b.value;
    for (int step = 1; step < steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const int beam = a.beam + static_cast<int>(std::lround(share * beams));
      const int bin = a.bin + static_cast<int>(std::lround(share * bins));
      if (plane_.at(beam, bin) < low) return true;
    }
    return false;
  }

  const ImagePlane& plane_;
  EchoExtent extent_;
  float valley_, sidelobe_;
};

}  // namespace

void leave_one_peak_an_echo(const ImagePlane& plane, const EchoExtent& extent, const EchoParams& params,
                            std::vector<PlanePeak>& peaks) {
  std::sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.value > b.value; });
  const EchoRule rule(plane, extent, params);
  // From the weakest up, so that a peak is also compared with those that are themselves part of an echo.
  std::size_t kept = peaks.size();
  for (std::size_t weak = peaks.size(); weak-- > 1;) {
    const auto strong_end = peaks.begin() + static_cast<std::ptrdiff_t>(weak);
    const bool is_part = std::any_of(peaks.begin(), strong_end, [&](const PlanePeak& strong) {
      return rule.one_echo(strong, peaks[weak]);
    });
    if (!is_part) std::swap(peaks[--kept], peaks[weak]);
  }
  if (!peaks.empty()) std::swap(peaks[--kept], peaks[0]);
  peaks.erase(peaks.begin(), peaks.begin() + static_cast<std::ptrdiff_t>(kept));
}

}  // namespace lookout::tracking
