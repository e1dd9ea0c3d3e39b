#include "sonar_sim/sea/clutter_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/field_of_view.hpp"

namespace lookout::sonar_sim {
namespace {

using core::Random;

struct Interval {
  double low = 0.0, high = 0.0;
};

bool holds_bearing(const ClutterPatch& patch, double bearing) {
  const double middle = 0.5 * (patch.first_bearing + patch.last_bearing);
  const double half = 0.5 * (patch.last_bearing - patch.first_bearing);
  return std::abs(core::wrap_to_pi(bearing - middle)) <= half;
}

/// Ranges at which a ray from the sonar at `bearing` lies in the disc.
std::optional<Interval> chord(const ClutterPatch& patch, const Ping& ping, double bearing) {
  const Eigen::Vector2d p_sonar = core::inverse_transform(ping.T_earth_sonar, patch.centre);
  const double along = p_sonar.x() * std::cos(bearing) + p_sonar.y() * std::sin(bearing);
  const double half_squared = patch.radius * patch.radius - (p_sonar.squaredNorm() - along * along);
  if (half_squared <= 0.0) return std::nullopt;
  const double half = std::sqrt(half_squared);
  const Interval ranges{std::max(0.0, along - half), std::min(ping.params.max_range, along + half)};
  return ranges.low < ranges.high ? std::optional(ranges) : std::nullopt;
}

/// Ranges at which a beam lies in the patch.
std::optional<Interval> ranges_in(const ClutterPatch& patch, const Ping& ping, int beam) {
  const double bearing = ping.params.beam_centre(beam);
  if (patch.on_earth) return chord(patch, ping, bearing);
  return holds_bearing(patch, bearing) ? std::optional(Interval{patch.nearest, patch.farthest})
                                       : std::nullopt;
}

std::vector<BeamReturn> draw_by_beam(const ClutterPatch& patch, const Ping& ping, Random& random) {
  std::vector<BeamReturn> heard;
  for (int beam = 0; beam < ping.params.num_beams; ++beam) {
    const auto ranges = ranges_in(patch, ping, beam);
    if (!ranges || !random.bernoulli(*patch.probability)) continue;
    const double range = random.uniform(ranges->low, ranges->high);
    if (ping.in_range(range))
      heard.push_back({beam, {ping.params.beam_centre(beam), range, 1.0}, Source::clutter});
  }
  return heard;
}

/// A point of the patch, uniform in range and bearing, or over the disc.
core::SonarPoint draw_point(const ClutterPatch& patch, const Ping& ping, Random& random) {
  if (patch.on_earth) {
    const double radius = patch.radius * std::sqrt(random.uniform(0.0, 1.0));
    const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
    return core::observe(ping.params, ping.T_earth_sonar, patch.centre + core::from_polar(radius, azimuth));
  }
  core::SonarPoint point;
  point.bearing = core::wrap_to_pi(random.uniform(patch.first_bearing, patch.last_bearing));
  point.range = random.uniform(patch.nearest, patch.farthest);
  point.beam = ping.params.beam_of(point.bearing);
  point.in_range = ping.in_range(point.range);
  return point;
}

std::vector<BeamReturn> draw_by_number(const ClutterPatch& patch, const Ping& ping, Random& random) {
  std::vector<BeamReturn> heard;
  for (int left = random.poisson(*patch.mean_returns); left > 0; --left) {
    const core::SonarPoint point = draw_point(patch, ping, random);
    if (!point.visible()) continue;
    const int beam = ping.params.beam_of(point.bearing);
    heard.push_back({beam, {ping.reported_bearing(beam, point.bearing), point.range, 1.0}, Source::clutter});
  }
  return heard;
}

}  // namespace

std::vector<BeamReturn> draw_patch(const ClutterPatch& patch, const Ping& ping, Random& random) {
  return patch.probability ? draw_by_beam(patch, ping, random) : draw_by_number(patch, ping, random);
}

}  // namespace lookout::sonar_sim
