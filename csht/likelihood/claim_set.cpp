#include "csht/likelihood/claim_set.hpp"

#include <algorithm>
#include <cmath>

#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {
namespace {

double return_weight(const ScanTable& scan, double range, double bearing, std::size_t detection) {
  const double dr = (range - scan.detections[detection].range) * scan.inverse_sigma;
  const double db =
      core::wrap_to_pi(bearing - scan.bearing_from_axis[detection]) * scan.inverse_bearing_sigma;
  const double gain = scan.gain * scan.worth[detection] * std::exp(-0.5 * (dr * dr + db * db));
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
  copy(samples);
  for (int age = 0; age < window_scans_; ++age) {
    const ScanTable& scan = history.at_age(age);
    BeamMask& mask = masks_[static_cast<std::size_t>(age)];
    locate(scan, {north_, east_, north_velocity_, east_velocity_}, history.seconds_at_age(age), range_,
           bearing_);
    if (scan.clutter == ClutterModel::point)
      claim_points(scan, existence, mask);
    else
      claim_beams(scan, existence, mask);
  }
}

// An array a component, as `locate` takes them.
void ClaimSet::copy(std::span<const Eigen::Vector4d> samples) {
  for (auto* values : {&north_, &east_, &north_velocity_, &east_velocity_}) values->resize(samples.size());
  range_.resize(samples.size());
  bearing_.resize(samples.size());
  touched_.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    north_[i] = samples[i][0];
    east_[i] = samples[i][1];
    north_velocity_[i] = samples[i][2];
    east_velocity_[i] = samples[i][3];
  }
}

void ClaimSet::claim_beams(const ScanTable& scan, double existence, BeamMask& mask) {
  weight_.resize(std::max(weight_.size(), scan.range.size()), 0.0);
  range_sum_.resize(weight_.size(), 0.0);
  touched_.clear();
  for (std::size_t i = 0; i < range_.size(); ++i) {
    const double beam = static_cast<double>(bearing_[i]) / scan.bearing_step + 0.5 * scan.num_beams;
    const auto range = static_cast<double>(range_[i]);
    if (!(beam >= 0.0 && beam < scan.num_beams && range <= scan.max_range)) continue;  // NaN too.
    const auto index = static_cast<std::size_t>(beam);
    if (weight_[index] == 0.0) touched_.push_back(static_cast<int>(index));
    weight_[index] += 1.0;
    range_sum_[index] += range;
  }
  for (const int beam : touched_) {
    const auto index = static_cast<std::size_t>(beam);
    const double share = existence * weight_[index] / static_cast<double>(range_.size());
    claim_beam(scan, beam, range_sum_[index] / weight_[index], share, mask);
    weight_[index] = range_sum_[index] = 0.0;
  }
}

void ClaimSet::claim_points(const ScanTable& scan, double existence, BeamMask& mask) const {
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    double share = 0.0;
    for (std::size_t i = 0; i < range_.size(); ++i)
      share += return_weight(scan, static_cast<double>(range_[i]), static_cast<double>(bearing_[i]), j);
    claim_detection(j, existence * share / static_cast<double>(range_.size()), mask);
  }
}

}  // namespace lookout::csht
