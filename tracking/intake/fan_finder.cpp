#include "tracking/intake/fan_finder.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/beam_bearings.hpp"

namespace lookout::tracking {
namespace {

constexpr int kLeastBeams = 8;    // Of fewer the two laws hardly differ.
constexpr double kOnBeam = 0.02;  // A return so near to a centre is at it [beams]: drivers round.
constexpr int kEnough = 4;        // Returns at the one law's centres and off the other's: by chance 3 in 1e6,
constexpr int kToAStray = 20;     // with one that is off both to so many.
constexpr int kTooMany = 64;      // After so many without a decision the beams are taken for even.

/// The fan with the same outer beams whose centres are even in sine; null where there is none.
std::shared_ptr<const core::UnevenFan> even_in_sine(const core::SonarScan& scan) {
  const double first = scan.first_bearing, last = first + (scan.num_beams - 1) * scan.bearing_step;
  const double quarter = 0.5 * std::numbers::pi;
  if (scan.num_beams < kLeastBeams || first < -quarter || last > quarter) return nullptr;
  const double begin = std::sin(first), step = (std::sin(last) - begin) / (scan.num_beams - 1);
  std::vector<double> centres{first};
  for (int beam = 1; beam + 1 < scan.num_beams; ++beam) centres.push_back(std::asin(begin + beam * step));
  centres.push_back(last);
  if (!core::is_beam_table(centres)) return nullptr;
  return std::make_shared<const core::UnevenFan>(std::move(centres));
}

bool off_centre(double place) {
  return std::abs(place - std::round(place)) > kOnBeam;
}

}  // namespace

std::shared_ptr<const core::UnevenFan> FanFinder::fan_of(const core::SonarScan& scan,
                                                         const core::SonarParams& configured) {
  if (configured.point_sensor()) return nullptr;
  if (configured.fan && configured.fan->fits(scan.num_beams, scan.first_bearing, scan.bearing_step)) {
    num_beams_ = 0;  // There is nothing to find.
    even_in_sine_.reset();
    return configured.fan;
  }
  if (scan.num_beams != num_beams_ || scan.first_bearing != first_bearing_ ||
      scan.bearing_step != bearing_step_)
    begin(scan);
  return found_ ? even_in_sine_ : nullptr;
}

void FanFinder::begin(const core::SonarScan& scan) {
  num_beams_ = scan.num_beams;
  first_bearing_ = scan.first_bearing;
  bearing_step_ = scan.bearing_step;
  even_in_sine_ = even_in_sine(scan);
  on_sine_ = on_neither_ = 0;
  found_ = false;
}

bool FanFinder::learn(const core::SonarScan& scan) {
  if (found_ || !even_in_sine_) return false;
  for (const core::SonarReturn& one : scan.returns) {
    if (!off_centre((one.bearing - first_bearing_) / bearing_step_)) continue;
    ++(off_centre(even_in_sine_->place_of(one.bearing)) ? on_neither_ : on_sine_);
  }
  found_ = on_sine_ >= kEnough && on_neither_ * kToAStray <= on_sine_;
  if (!found_ && on_sine_ + on_neither_ >= kTooMany) even_in_sine_.reset();
  return found_;
}

}  // namespace lookout::tracking
