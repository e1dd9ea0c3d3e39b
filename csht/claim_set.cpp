#include "csht/claim_set.hpp"

#include <algorithm>
#include <cmath>

#include "csht/fast_math.hpp"

namespace lookout::csht {
namespace {

struct SeenAt {
  double range = 0.0;    // [m]
  double bearing = 0.0;  // From the axis [rad].
};

SeenAt seen_at(const ScanTable& scan, const Eigen::Vector4d& state, double seconds) {
  const auto dn = static_cast<float>(state[0] + seconds * state[2] - scan.T_earth_sonar.north);
  const auto de = static_cast<float>(state[1] + seconds * state[3] - scan.T_earth_sonar.east);
  const auto c = static_cast<float>(scan.cos_axis), s = static_cast<float>(scan.sin_axis);
  return {std::sqrt(dn * dn + de * de), fast_atan2(c * de - s * dn, c * dn + s * de)};
}

double echo_weight(const ScanTable& scan, const SeenAt& seen, std::size_t detection) {
  const double dr = (seen.range - scan.detections[detection].range) * scan.inverse_sigma;
  const double db =
      core::wrap_to_pi(seen.bearing - scan.bearing_from_axis[detection]) * scan.inverse_bearing_sigma;
  const double gain = scan.gain * std::exp(-0.5 * (dr * dr + db * db));
  return gain / (gain + scan.base[1]);
}

}  // namespace

void ClaimSet::clear(const ScanHistory& history, int window_scans) {
  window_scans_ = std::min(window_scans, history.size());
  if (masks_.size() < static_cast<std::size_t>(window_scans_))
    masks_.resize(static_cast<std::size_t>(window_scans_));
  for (int age = 0; age < window_scans_; ++age)
    masks_[static_cast<std::size_t>(age)].clear(history.at_age(age));
}

const BeamMask* ClaimSet::at_age(int age) const {
  if (age >= window_scans_ || masks_[static_cast<std::size_t>(age)].empty) return nullptr;
  return &masks_[static_cast<std::size_t>(age)];
}

void ClaimSet::claim(const ScanHistory& history, std::span<const Eigen::Vector4d> samples, double existence) {
  for (int age = 0; age < window_scans_; ++age) {
    const ScanTable& scan = history.at_age(age);
    BeamMask& mask = masks_[static_cast<std::size_t>(age)];
    const double seconds = history.seconds_at_age(age);
    if (scan.clutter == ClutterModel::point)
      claim_points(scan, samples, seconds, existence, mask);
    else
      claim_beams(scan, samples, seconds, existence, mask);
  }
}

void ClaimSet::claim_beams(const ScanTable& scan, std::span<const Eigen::Vector4d> samples, double seconds,
                           double existence, BeamMask& mask) {
  weight_.resize(std::max(weight_.size(), scan.range.size()), 0.0);
  range_.resize(weight_.size(), 0.0);
  touched_.clear();
  for (const auto& sample : samples) {
    const SeenAt seen = seen_at(scan, sample, seconds);
    const double beam = seen.bearing / scan.bearing_step + 0.5 * scan.num_beams;
    if (beam < 0.0 || beam >= scan.num_beams || seen.range > scan.max_range) continue;
    const auto index = static_cast<std::size_t>(beam);
    if (weight_[index] == 0.0) touched_.push_back(static_cast<int>(index));
    weight_[index] += 1.0;
    range_[index] += seen.range;
  }
  for (const int beam : touched_) {
    const auto index = static_cast<std::size_t>(beam);
    const double share = existence * weight_[index] / static_cast<double>(samples.size());
    claim_beam(scan, beam, range_[index] / weight_[index], share, mask);
    weight_[index] = range_[index] = 0.0;
  }
}

void ClaimSet::claim_points(const ScanTable& scan, std::span<const Eigen::Vector4d> samples, double seconds,
                            double existence, BeamMask& mask) const {
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    double share = 0.0;
    for (const auto& sample : samples) share += echo_weight(scan, seen_at(scan, sample, seconds), j);
    claim_detection(j, existence * share / static_cast<double>(samples.size()), mask);
  }
}

}  // namespace lookout::csht
