#include "sonar_sim/sea/standing_things.hpp"

#include <cmath>
#include <numbers>

#include "core/field_of_view.hpp"

namespace lookout::sonar_sim {
namespace {

using core::Random;
using Eigen::Vector2d;

constexpr double kWallRangeSigma = 1.0;  // m, as documented at StandingEcho

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool holds_azimuth(const StandingArc& arc, double azimuth) {
  const double turn = 2.0 * std::numbers::pi;
  const double past_first = std::fmod(std::fmod(azimuth - arc.first_azimuth, turn) + turn, turn);
  return past_first <= arc.last_azimuth - arc.first_azimuth;
}

/// Collects the returns of one ping; standing things count down from -1.
struct Collector {
  const Ping& ping;
  Random& random;
  std::vector<BeamReturn> heard = {};
  int thing = 0;

  void add(int beam, double bearing, double range, const StandingEcho& echo, double sigma) {
    if (!random.bernoulli(echo.probability)) return;
    range += random.gaussian(sigma);
    if (!ping.in_range(range)) return;
    heard.push_back({beam, {bearing, range, 1.0}, Source::standing, thing, echo.snr_db});
  }

  void add_point(const StandingPoint& point) {
    --thing;
    const auto seen = core::observe(ping.params, ping.T_earth_sonar, point.position);
    if (!seen.visible()) return;
    const int beam = ping.params.beam_of(seen.bearing);
    add(beam, ping.reported_bearing(beam, seen.bearing), seen.range, point.echo,
        point.echo.range_sigma.value_or(ping.echo_range_sigma));
  }

  template <class Wall>
  void add_wall(const Wall& wall) {
    --thing;
    const Vector2d p_earth{ping.T_earth_sonar.north, ping.T_earth_sonar.east};
    for (int beam = 0; beam < ping.params.num_beams; ++beam) {
      const double bearing = ping.params.beam_centre(beam);
      const auto range = range_to(wall, p_earth, ping.T_earth_sonar.heading + bearing);
      if (range && ping.in_range(*range))
        add(beam, bearing, *range, wall.echo, wall.echo.range_sigma.value_or(kWallRangeSigma));
    }
  }
};

}  // namespace

StandingPlan place_fields(StandingPlan plan, Random& random) {
  for (const auto& field : plan.fields) {
    for (int i = 0; i < field.count; ++i) {
      const double north = random.uniform(field.south_west.x(), field.north_east.x());
      const double east = random.uniform(field.south_west.y(), field.north_east.y());
      plan.points.push_back({{north, east}, field.echo});
    }
  }
  plan.fields.clear();
  return plan;
}

std::optional<double> range_to(const StandingLine& line, const Vector2d& p_earth, double azimuth) {
  // p + r u = from + s (to - from), solved for r and s with cross products.
  const Vector2d u = core::from_polar(1.0, azimuth), along = line.to - line.from, off = line.from - p_earth;
  const double denominator = cross(u, along);
  if (denominator == 0.0) return std::nullopt;
  const double range = cross(off, along) / denominator, share = cross(off, u) / denominator;
  return range > 0.0 && share >= 0.0 && share <= 1.0 ? std::optional(range) : std::nullopt;
}

std::optional<double> range_to(const StandingArc& arc, const Vector2d& p_earth, double azimuth) {
  // |p + r u - centre|^2 = radius^2, a quadratic in r.
  const Vector2d u = core::from_polar(1.0, azimuth), off = arc.centre - p_earth;
  const double along = off.dot(u);
  const double half_squared = arc.radius * arc.radius - (off.squaredNorm() - along * along);
  if (half_squared < 0.0) return std::nullopt;
  for (const double range : {along - std::sqrt(half_squared), along + std::sqrt(half_squared)}) {
    const Vector2d from_centre = range * u - off;
    if (range > 0.0 && holds_azimuth(arc, std::atan2(from_centre.y(), from_centre.x()))) return range;
  }
  return std::nullopt;
}

std::vector<BeamReturn> draw_standing(const StandingPlan& plan, const Ping& ping, Random& random) {
  Collector collector{ping, random};
  for (const auto& point : plan.points) collector.add_point(point);
  for (const auto& line : plan.lines) collector.add_wall(line);
  for (const auto& arc : plan.arcs) collector.add_wall(arc);
  return std::move(collector.heard);
}

}  // namespace lookout::sonar_sim
