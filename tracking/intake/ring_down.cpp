#include "tracking/intake/ring_down.hpp"

#include <algorithm>
#include <limits>

#include "tracking/intake/crowded_scan.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {
namespace {

/// Where among the nearest returns of the beams, from the nearest on, the ring surely is, if there is one.
constexpr std::size_t kQuarter = 4;

/// Times that a ring is denser than what lies behind it: in dense clutter the nearest returns are near, too.
constexpr double kDenser = 3.0;

}  // namespace

std::int64_t RingDown::drop(core::SonarScan& scan, double range_sigma) {
  seen_[count_++ % kScans] = look_at(scan, range_sigma);
  const double rings_to = edge();
  return static_cast<std::int64_t>(
      std::erase_if(scan.returns, [rings_to](const auto& one) { return one.range <= rings_to; }));
}

std::int64_t RingDown::drop(core::SonarImage& /*image*/, double /*range_sigma*/) {
  return 0;
}

RingDown::Seen RingDown::look_at(const core::SonarScan& scan, double range_sigma) {
  Seen seen;
  const auto beams = static_cast<std::size_t>(scan.num_beams);
  if (2 * scan.returns.size() < beams) return seen;
  nearest_.assign(beams, std::numeric_limits<double>::infinity());
  for (const core::SonarReturn& one : scan.returns) {
    const int beam = beam_of(scan, one.bearing);
    if (beam < 0 || beam >= scan.num_beams) continue;
    double& nearest = nearest_[static_cast<std::size_t>(beam)];
    nearest = std::min(nearest, one.range);
  }
  seen.behind = returns_behind(scan, heard_);
  const auto quarter = nearest_.begin() + static_cast<std::ptrdiff_t>(beams / kQuarter);
  std::nth_element(nearest_.begin(), quarter, nearest_.end());
  const double ring = *quarter;
  const auto rings = std::count_if(nearest_.begin(), nearest_.end(), [ring, range_sigma](double range) {
    return std::abs(range - ring) <= range_sigma;
  });
  const double edge = ring + range_sigma;
  const auto beyond = std::count_if(scan.returns.begin(), scan.returns.end(),
                                    [edge](const auto& one) { return one.range > edge; });
  // What as many metres hold where nothing rings.
  const double usual = static_cast<double>(beyond) * 2.0 * range_sigma / (scan.max_range - edge);
  if (ring <= kNear * scan.max_range && static_cast<double>(rings) >= kMostBeams * scan.num_beams &&
      static_cast<double>(rings) > kDenser * usual)
    seen.edge = edge;
  return seen;
}

/// The farthest of the scans that ring; 0 where too few do.
double RingDown::edge() const {
  const auto rings = std::count_if(seen_.begin(), seen_.end(), [](const Seen& s) { return s.edge > 0.0; });
  std::int64_t behind = 0;
  double farthest = 0.0;
  for (const Seen& seen : seen_) {
    behind += seen.behind;
    farthest = std::max(farthest, seen.edge);
  }
  return rings >= kFewestRinging && behind >= kFewestBehind ? farthest : 0.0;
}

}  // namespace lookout::tracking
