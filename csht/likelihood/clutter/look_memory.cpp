#include "csht/likelihood/clutter/look_memory.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {

SeenPlace seen_place(const ScanTable& scan, const core::Detection& detection) {
  const auto slot = static_cast<std::size_t>(detection.beam) + 1;
  const bool in_beam = detection.beam >= 0 && detection.beam < scan.num_beams;
  const double beam = scan.beams_from_middle(core::wrap_to_pi(detection.azimuth - scan.axis));
  if (in_beam && scan.clutter != ClutterModel::point && scan.echo_offset[slot] != 0.0F) {
    const double middle = beam + static_cast<double>(scan.echo_offset[slot]);
    const double azimuth = scan.axis + scan.bearing_of_beams(middle);
    return {detection.p_earth_sonar + core::from_polar(detection.range, azimuth), middle, detection.range};
  }
  return {detection.p_earth, beam, detection.range};
}

SeenPlace seen_place(const ScanTable& scan, const Eigen::Vector2d& p_earth) {
  const Eigen::Vector2d from = p_earth - Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  return {p_earth, scan.beams_from_middle(core::wrap_to_pi(std::atan2(from.y(), from.x()) - scan.axis)),
          from.norm()};
}

LookMemory::LookMemory(const Limits& limits) : limits_(limits) {
  looks_.reserve(limits_.most_looks);
  spare_.resize(limits_.most_looks);
  for (Look& look : spare_) {
    look.earth.reserve(limits_.most_returns);
    look.in_sonar.reserve(limits_.most_returns);
  }
  const std::size_t most = limits_.most_looks * limits_.most_returns;
  for (PointBins* bins : {&earth_, &in_sonar_}) bins->reserve(most);
  points_.reserve(most);
}

bool LookMemory::add(const ScanTable& scan) {
  if (!looks_.empty() && scan.utime - looks_.back().utime < limits_.spacing_us) return false;
  Look& look = next_look();
  look.utime = scan.utime;
  look.T_earth_sonar = scan.T_earth_sonar;
  look.cos_axis = scan.cos_axis;
  look.sin_axis = scan.sin_axis;
  look.cos_half_sector = scan.cos_half_sector;
  look.max_range = scan.max_range;
  const std::size_t stride = scan.detections.size() / (limits_.most_returns + 1) + 1;
  for (std::size_t j = 0; j < scan.detections.size(); j += stride)
    take_return(scan, scan.detections[j], static_cast<float>(stride), look);
  sort_returns();
  return true;
}

// The look that takes the newest scan: a new one or, where there are enough, the oldest, with its buffers.
Look& LookMemory::next_look() {
  const int number = looks_.empty() ? 0 : looks_.back().number + 1;
  if (spare_.empty()) {
    std::rotate(looks_.begin(), looks_.begin() + 1, looks_.end());
  } else {
    looks_.push_back(std::move(spare_.back()));
    spare_.pop_back();
  }
  Look& look = looks_.back();
  look.number = number;
  look.earth.clear();
  look.in_sonar.clear();
  return look;
}

void LookMemory::take_return(const ScanTable& scan, const core::Detection& detection, float weight,
                             Look& look) {
  const SeenPlace place = seen_place(scan, detection);
  const bool in_beam =
      scan.clutter != ClutterModel::point && detection.beam >= 0 && detection.beam < scan.num_beams;
  const float own = in_beam ? weight * scan.share[static_cast<std::size_t>(detection.beam) + 1] : weight;
  look.earth.push_back(
      {static_cast<float>(place.p_earth.x()), static_cast<float>(place.p_earth.y()), own, look.number});
  // Of beams too narrow for a float all returns but the axis's lie at the edges.
  const double beam = std::clamp(place.beam, -1.0 * scan.num_beams, 1.0 * scan.num_beams);
  look.in_sonar.push_back(
      {static_cast<float>(beam), static_cast<float>(place.range / limits_.range_reach), own, look.number});
}

void LookMemory::sort_returns() {
  points_.clear();
  for (const Look& look : looks_) points_.insert(points_.end(), look.earth.begin(), look.earth.end());
  earth_.build(points_, limits_.range_reach);
  points_.clear();
  for (const Look& look : looks_) points_.insert(points_.end(), look.in_sonar.begin(), look.in_sonar.end());
  in_sonar_.build(points_, 1.0);
}

Look* LookMemory::look_at(const ScanTable& scan) {
  const auto look =
      std::find_if(looks_.begin(), looks_.end(), [&](const Look& l) { return l.utime == scan.utime; });
  if (look == looks_.end() || look->earth.size() != scan.detections.size()) return nullptr;
  return &*look;
}

SeenPlace LookMemory::place_around(const ScanTable& scan, const BinnedPoint& in_sonar) const {
  const double beam = static_cast<double>(in_sonar.x);
  const double range = static_cast<double>(in_sonar.y) * limits_.range_reach;
  const double azimuth = scan.axis + scan.bearing_of_beams(beam);
  return {{scan.T_earth_sonar.north + range * std::cos(azimuth),
           scan.T_earth_sonar.east + range * std::sin(azimuth)},
          beam,
          range};
}

}  // namespace lookout::csht
