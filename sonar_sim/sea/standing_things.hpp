#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "sonar_sim/ping.hpp"

/// Things that stand on the earth and return the ping: never targets, and never in the truth.
namespace lookout::sonar_sim {

/// How a standing thing is heard.
struct StandingEcho {
  double probability = 0.7;           ///< Of a return at a ping (of a line or arc: in each beam), in [0, 1].
  std::optional<double> range_sigma;  ///< [m], >= 0; absent: the sonar's for points, 1 m for lines and arcs.
  std::optional<double> snr_db;       ///< Mean power over the clutter's; absent: the sea's.
};

/// A rock, a buoy, a pile: heard in the beam that it lies in.
struct StandingPoint {
  Eigen::Vector2d position{0, 0};  ///< North, east [m].
  /// How it answers a ping.
  StandingEcho echo;
};

/// A wall: heard in each beam whose axis meets it.
struct StandingLine {
  Eigen::Vector2d from{0, 0}, to{0, 0};  ///< Its ends: north, east [m].
  /// How it answers a ping.
  StandingEcho echo;
};

/// A bent wall.
struct StandingArc {
  Eigen::Vector2d centre{0, 0};  ///< North, east [m].
  double radius = 0.0;           ///< [m], > 0.
  double first_azimuth = 0.0;    ///< As seen from its centre, clockwise from north, it reaches from the first
  double last_azimuth = 0.0;     ///< to the last, which is larger by at most a turn [rad].
  /// How it answers a ping.
  StandingEcho echo;
};

/// Points strewn over a rectangle, anew for each seed and run.
struct StandingField {
  int count = 0;                                       ///< >= 1.
  Eigen::Vector2d south_west{0, 0}, north_east{0, 0};  ///< Corners: north, east [m].
  /// How it answers a ping.
  StandingEcho echo;
};

/// All standing things of a scene.
struct StandingPlan {
  /// Rocks and the like.
  std::vector<StandingPoint> points;
  /// Walls.
  std::vector<StandingLine> lines;
  /// Round walls.
  std::vector<StandingArc> arcs;
  /// Areas with points at random.
  std::vector<StandingField> fields;
};

/// The plan with each field's points in the place of the field.
StandingPlan place_fields(StandingPlan plan, core::Random& random);

/// Range [m] at which a ray from the earth-frame point `p_earth` at `azimuth` [rad] first meets the thing.
std::optional<double> range_to(const StandingLine& line, const Eigen::Vector2d& p_earth, double azimuth);
/// Range along a ray to the thing [m]; nothing where the ray misses it.
std::optional<double> range_to(const StandingArc& arc, const Eigen::Vector2d& p_earth, double azimuth);

/// The returns of all points, lines and arcs of the plan.
std::vector<BeamReturn> draw_standing(const StandingPlan& plan, const Ping& ping, core::Random& random);

}  // namespace lookout::sonar_sim
