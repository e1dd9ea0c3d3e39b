#include "sonar_sim/image/standing_echoes.hpp"

#include <cmath>

#include "core/beam_bearings.hpp"

namespace lookout::sonar_sim {
namespace {

/// Of one of several scatterers whose powers add.
double shared_snr_db(double snr_db) {
  return snr_db - 10.0 * std::log10(static_cast<double>(kScatterersPerBeam));
}

/// Collects what one ping meets.
struct View {
  const core::SonarImage& image;
  const core::Pose2& T_earth_sonar;
  double snr_db;
  std::vector<StandingScatterer> seen = {};

  void add_point(const StandingPoint& point) {
    const Eigen::Vector2d p_sonar = core::inverse_transform(T_earth_sonar, point.position);
    const double bearing = std::atan2(p_sonar.y(), p_sonar.x());
    const double place = core::place_of(image.bearings, bearing);
    if (place < -0.5 || place > image.num_beams() - 0.5) return;
    seen.push_back({p_sonar.norm(), bearing, point.echo.snr_db.value_or(snr_db), false});
  }

  template <class Wall>
  void add_wall(const Wall& wall) {
    const Eigen::Vector2d p_earth{T_earth_sonar.north, T_earth_sonar.east};
    for (int k = 0; k < kScatterersPerBeam * image.num_beams(); ++k) {
      const double bearing = core::bearing_at(image.bearings, (k + 0.5) / kScatterersPerBeam - 0.5);
      const auto range = range_to(wall, p_earth, T_earth_sonar.heading + bearing);
      if (range) seen.push_back({*range, bearing, shared_snr_db(wall.echo.snr_db.value_or(snr_db)), true});
    }
  }
};

}  // namespace

std::vector<StandingScatterer> standing_in_view(const StandingPlan& plan, const core::SonarImage& image,
                                                const core::Pose2& T_earth_sonar, double snr_db) {
  View view{image, T_earth_sonar, snr_db};
  for (const auto& point : plan.points) view.add_point(point);
  for (const auto& line : plan.lines) view.add_wall(line);
  for (const auto& arc : plan.arcs) view.add_wall(arc);
  return std::move(view.seen);
}

}  // namespace lookout::sonar_sim
