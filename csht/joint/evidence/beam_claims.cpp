#include "csht/joint/evidence/beam_claims.hpp"

#include <algorithm>
#include <cmath>

#include "csht/likelihood/blurred_likelihood.hpp"

namespace lookout::csht {
namespace {

Eigen::Vector2d moved(const TrajectoryCloud& cloud, std::size_t i, double seconds) {
  if (cloud.motion != Motion::constant_velocity)
    return position_at(cloud.motion, cloud.trajectory(i), seconds);
  return {cloud.north[i] + seconds * cloud.north_velocity[i],
          cloud.east[i] + seconds * cloud.east_velocity[i]};
}

double total_weight(const TrajectoryCloud& cloud, std::size_t stride) {
  double total = 0.0;
  for (std::size_t i = 0; i < cloud.size(); i += stride) total += cloud.weight[i];
  return std::max(total, 1e-9);
}

}  // namespace

void BeamClaims::observe(int slot, TargetTrack& track, bool claim, ScanLikelihood& likelihood) {
  const View view = look(slot, track.cloud, 0, claim, 1, likelihood);
  track.visible_share = view.visible;
  track.detected_share = view.detected;
}

void BeamClaims::claim_memory(int slot, TargetTrack& track, const AgeSpan& memory,
                              ScanLikelihood& likelihood) {
  likelihood.set_existence(slot, track.existence());
  likelihood.forget_claims(slot, 0);
  const bool claims = track.existence() >= ScanLikelihood::kLeastExistence;
  observe(slot, track, claims, likelihood);
  if (!claims || track.claims_are_fresh) return;
  claim_past(slot, track, memory.oldest, likelihood);
  track.claims_are_fresh = true;
}

void BeamClaims::claim_past(int slot, TargetTrack& track, int oldest, ScanLikelihood& likelihood) {
  track.own_detections = track.detected_share;
  for (int age = 1; age <= oldest; ++age) {
    if (track.has_claims) likelihood.forget_claims(slot, age);
    const auto stride = static_cast<std::size_t>(params_.past_stride);
    track.own_detections += look(slot, track.cloud, age, true, stride, likelihood).detected;
  }
  track.has_claims = true;
}

BeamClaims::View BeamClaims::look(int slot, const TrajectoryCloud& cloud, int age, bool claim,
                                  std::size_t stride, ScanLikelihood& likelihood) {
  const ScanTable& scan = likelihood.scans().at_age(age);
  const double seconds = likelihood.scans().seconds_at_age(age);
  const bool points = scan.clutter == ClutterModel::point;
  const std::size_t size = points ? scan.detections.size() : static_cast<std::size_t>(scan.num_beams);
  if (share_.size() < size) share_.resize(size, 0.0);
  if (range_.size() < size) range_.resize(size, 0.0);
  touched_.clear();
  touched_.reserve(share_.size());
  const View view = points                ? look_points(cloud, age, stride, likelihood)
                    : scan.blur_reach > 0 ? look_blurred(cloud, scan, seconds, stride)
                                          : look_beams(cloud, scan, seconds, stride);
  const double total = total_weight(cloud, stride);
  for (const int index : touched_) {
    const auto k = static_cast<std::size_t>(index);
    if (claim && share_[k] > params_.least_share * total)
      likelihood.add_claim(age, {slot, index, static_cast<float>(range_[k] / share_[k]),
                                 static_cast<float>(share_[k] / total)});
    share_[k] = 0.0;
    range_[k] = 0.0;
  }
  return {view.visible / total, view.detected / total};
}

// Where the pose is uncertain, a target may have been in any of several beams: each has the probability that
// `beam_shares` gives it after what the beams returned.
BeamClaims::View BeamClaims::look_blurred(const TrajectoryCloud& cloud, const ScanTable& scan, double seconds,
                                          std::size_t stride) {
  const double gate = params_.detection_sigmas / static_cast<double>(scan.inverse_sigma);
  View view;
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    const Eigen::Vector2d at = moved(cloud, i, seconds);
    const double range = std::hypot(at.x() - scan.T_earth_sonar.north, at.y() - scan.T_earth_sonar.east);
    if (range > scan.max_range) continue;
    const BeamShares shares = beam_shares(scan, at, {});
    for (std::size_t k = 0; k < static_cast<std::size_t>(shares.count); ++k) {
      const int beam = shares.beam[k];
      if (beam < 0 || beam >= scan.num_beams) continue;
      const auto b = static_cast<std::size_t>(beam);
      const double weight = cloud.weight[i] * shares.share[k];
      if (share_[b] == 0.0) touched_.push_back(beam);
      share_[b] += weight;
      range_[b] += weight * range;
      view.visible += weight;
      if (std::abs(static_cast<double>(scan.range[b + 1]) - range) < gate) view.detected += weight;
    }
  }
  return view;
}

BeamClaims::View BeamClaims::look_beams(const TrajectoryCloud& cloud, const ScanTable& scan, double seconds,
                                        std::size_t stride) {
  const double gate = params_.detection_sigmas / static_cast<double>(scan.inverse_sigma);
  View view;
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    const Eigen::Vector2d at = moved(cloud, i, seconds);
    const int beam = beam_at(scan, at.x(), at.y());
    const double range = std::hypot(at.x() - scan.T_earth_sonar.north, at.y() - scan.T_earth_sonar.east);
    if (beam < 0 || beam >= scan.num_beams || range > scan.max_range) continue;
    const auto b = static_cast<std::size_t>(beam);
    if (share_[b] == 0.0) touched_.push_back(beam);
    share_[b] += cloud.weight[i];
    range_[b] += cloud.weight[i] * range;
    view.visible += cloud.weight[i];
    if (std::abs(static_cast<double>(scan.range[b + 1]) - range) < gate) view.detected += cloud.weight[i];
  }
  return view;
}

// For a sensor without beams: how probably each detection is the track's.
BeamClaims::View BeamClaims::look_points(const TrajectoryCloud& cloud, int age, std::size_t stride,
                                         const ScanLikelihood& likelihood) {
  const ScanTable& scan = likelihood.scans().at_age(age);
  const SensorFigures& figures = likelihood.scans().figures();
  const double seconds = likelihood.scans().seconds_at_age(age);
  const Tolerance tolerance = likelihood.tolerance_at(age, cloud.trajectory(0));
  const double scale = 1.0 / tolerance.sigma_scale;
  const std::size_t count = scan.detections.size();
  View view;
  for (std::size_t j = 0; j < count; ++j) touched_.push_back(static_cast<int>(j));
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    const Eigen::Vector2d at = moved(cloud, i, seconds);
    const double north = at.x() - scan.T_earth_sonar.north, east = at.y() - scan.T_earth_sonar.east;
    const double range = std::hypot(north, east), azimuth = std::atan2(east, north);
    const double off_axis = std::abs(core::wrap_to_pi(azimuth - scan.axis));
    if (range > scan.max_range || off_axis > static_cast<double>(scan.half_sector)) continue;
    view.visible += cloud.weight[i];
    double sum = figures.miss_probability;
    ratio_.assign(count, 0.0);
    for (std::size_t j = 0; j < count; ++j) {
      const double dr = (scan.detections[j].range - range) * scale / figures.range_sigma;
      const double db =
          core::wrap_to_pi(scan.detections[j].azimuth - azimuth) * scale / figures.bearing_sigma;
      sum += ratio_[j] = scale * scale * static_cast<double>(scan.gain * scan.worth[j]) *
                         std::exp(-0.5 * (dr * dr + db * db));
    }
    for (std::size_t j = 0; j < count; ++j) {
      const double share = cloud.weight[i] * ratio_[j] / sum;
      share_[j] += share;
      range_[j] += share * scan.detections[j].range;
      view.detected += share;
    }
  }
  return view;
}

}  // namespace lookout::csht
