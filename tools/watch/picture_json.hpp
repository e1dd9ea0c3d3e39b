#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tools/watch/heard.hpp"

/// What the browser view is sent, as JSON: SI units, radians, earth frame north-east, rounded to what a
/// screen can show. The page's fields are these.
namespace lookout::tools {

/// Half axes [m] and direction of the greater one [rad, clockwise from north] of the ellipse that holds a
/// position with probability 0.95.
struct Ellipse {
  double major = 0.0;
  double minor = 0.0;
  double heading = 0.0;
};
/// @param covariance of north and east [m^2]; what is not a covariance gives an ellipse of size 0.
Ellipse ellipse_95(const Eigen::Matrix2d& covariance);

nlohmann::json to_json(const core::Track& track);
nlohmann::json to_json(const Placed<core::SonarScan>& scan);

/// An image reduced to at most kMaxShownBeams x kMaxShownBins bytes by the largest value in each block; the
/// bytes, by beam, in base64.
nlohmann::json to_json(const Placed<core::SonarImage>& image);
inline constexpr int kMaxShownBeams = 128;
inline constexpr int kMaxShownBins = 200;

/// The newest of a topic; null where there is none. The status carries nodes, channels and complaints.
nlohmann::json picture_of(const Heard& heard, Topic topic, Heard::Clock::time_point now);

/// Every track of the last 30 s: {"ID": [[time_s, north, east, existence], ...], ...}.
nlohmann::json to_json(const TrackTrails& trails);

/// JSON as one line of text; what is no UTF-8 is replaced.
std::string line_of(const nlohmann::json& json);

}  // namespace lookout::tools
