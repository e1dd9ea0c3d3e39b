#include "csht/likelihood/point_likelihood.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "csht/likelihood/fast_math.hpp"
#include "csht/likelihood/range_gate.hpp"
#include "csht/likelihood/vector_clones.hpp"

namespace lookout::csht {
namespace {

// What a tolerance makes of a scan's Gaussian; wider is lower, so that it still averages 1 over clutter.
struct Shape {
  float gain, inverse_sigma, inverse_bearing_sigma;
};

Shape shape_of(const ScanTable& scan, const Tolerance& tolerance) {
  const auto scale = static_cast<float>(1.0 / tolerance.sigma_scale);
  return {scan.gain * scale * scale, scan.inverse_sigma * scale, scan.inverse_bearing_sigma * scale};
}

// Beyond so many sigmas a return adds nothing that a float could hold: exp(-40).
constexpr float kGate = 9.0F;
// Up to here a bearing of a sector does not come near another one the wrong way round [rad].
constexpr float kWidestSector = 2.0F, kWidestGate = 0.5F;

// Where the targets of a block are; a return outside of it is no target's.
struct Box {
  float nearest, farthest, first, last;
  bool holds(float range, float bearing) const {
    return range >= nearest && range <= farthest && bearing >= first && bearing <= last;
  }
};

struct Block {
  const float* range;    // From the sonar [m].
  const float* bearing;  // From the sector's middle [rad].
  float* ratio;
  std::size_t count;
};

inline __attribute__((always_inline)) float wrapped(float angle) {
  constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
  angle = angle > 0.5F * kTurn ? angle - kTurn : angle;
  return angle < -0.5F * kTurn ? angle + kTurn : angle;
}

Box box_of(const ScanTable& scan, const Shape& shape, std::span<const float> range,
           std::span<const float> bearing) {
  const auto [nearest, farthest] = std::minmax_element(range.begin(), range.end());
  const auto [first, last] = std::minmax_element(bearing.begin(), bearing.end());
  const float down = kGate / shape.inverse_sigma, across = kGate / shape.inverse_bearing_sigma;
  Box box{*nearest - down, *farthest + down, *first - across, *last + across};
  if (scan.half_sector <= kWidestSector && across <= kWidestGate) return box;
  box.first = -std::numeric_limits<float>::infinity();
  box.last = std::numeric_limits<float>::infinity();
  return box;
}

LOOKOUT_VECTOR_CLONES
void add_point(const Shape& shape, float gain, float range, float bearing, const Block& b) {
  for (std::size_t i = 0; i < b.count; ++i) {
    const float dr = (b.range[i] - range) * shape.inverse_sigma;
    const float db = wrapped(b.bearing[i] - bearing) * shape.inverse_bearing_sigma;
    b.ratio[i] += gain * fast_exp(-0.5F * (dr * dr + db * db));
  }
}

// Raises `merged` to the probability that a target has no return of its own because it is merged with this
// one.
LOOKOUT_VECTOR_CLONES
void merge_with(float inverse_resolution, float share, float range, float bearing, const Block& b,
                float* merged) {
  constexpr float kHalf = std::numbers::ln2_v<float>;
  for (std::size_t i = 0; i < b.count; ++i) {
    const float along = (b.range[i] - range) * inverse_resolution;
    const float across = range * wrapped(b.bearing[i] - bearing) * inverse_resolution;
    const float with_this = share * fast_exp(-kHalf * (along * along + across * across));
    merged[i] = with_this > merged[i] ? with_this : merged[i];
  }
}

LOOKOUT_VECTOR_CLONES
void forget_outside(const ScanTable& scan, const Block& b) {
  const auto max_range = static_cast<float>(scan.max_range);
  for (std::size_t i = 0; i < b.count; ++i) {
    const float off = b.bearing[i] < 0.0F ? -b.bearing[i] : b.bearing[i];
    const float inside = off <= scan.half_sector ? b.ratio[i] : 1.0F;
    b.ratio[i] = b.range[i] <= max_range ? inside : 1.0F;
  }
}

void merge_points(const ScanTable& scan, const BeamMask& mask, const Block& b) {
  std::array<float, kPointBlock> merged{};
  for (std::size_t j = 0; j < scan.detections.size(); ++j)
    merge_with(scan.inverse_resolution, mask.share[j], static_cast<float>(scan.detections[j].range),
               scan.bearing_from_axis[j], b, merged.data());
  for (std::size_t i = 0; i < b.count; ++i) b.ratio[i] += merged[i] * (1.0F - b.ratio[i]);
}

}  // namespace

void find_point_ratios(const ScanTable& scan, const BeamMask* mask, std::span<const float> range,
                       std::span<const float> bearing, const Tolerance& tolerance, std::span<float> ratio) {
  assert(range.size() <= kPointBlock);
  const Shape shape = shape_of(scan, tolerance);
  const Block block{range.data(), bearing.data(), ratio.data(), range.size()};
  std::array<float, kPointBlock> lost;
  std::fill(ratio.begin(), ratio.end(), scan.base[1]);
  if (find_lost_shares(static_cast<float>(scan.max_range), shape.inverse_sigma, range, lost))
    for (std::size_t i = 0; i < range.size(); ++i) ratio[i] += scan.lost[1] * lost[i];
  const Box box = box_of(scan, shape, range, bearing);
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    if (!box.holds(static_cast<float>(scan.detections[j].range), scan.bearing_from_axis[j])) continue;
    const float free = mask == nullptr ? 1.0F : 1.0F - mask->share[j];
    const float gain = shape.gain * scan.worth[j] * free;
    add_point(shape, gain, static_cast<float>(scan.detections[j].range), scan.bearing_from_axis[j], block);
  }
  if (mask != nullptr && scan.inverse_resolution > 0.0F) merge_points(scan, *mask, block);
  forget_outside(scan, block);
}

double plain_point_ratio(const ScanTable& scan, const BeamMask* mask, double range, double bearing,
                         const Tolerance& tolerance) {
  if (std::abs(bearing) > static_cast<double>(scan.half_sector)) return 1.0;
  const double scale = 1.0 / tolerance.sigma_scale;
  const double lost = lost_share(scan.max_range, scale * static_cast<double>(scan.inverse_sigma), range);
  double ratio = static_cast<double>(scan.base[1]) + static_cast<double>(scan.lost[1]) * lost, merged = 0.0;
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const double share = mask == nullptr ? 0.0 : static_cast<double>(mask->share[j]);
    const double turn = core::wrap_to_pi(bearing - static_cast<double>(scan.bearing_from_axis[j]));
    const double off = range - scan.detections[j].range;
    const double dr = off * scale * static_cast<double>(scan.inverse_sigma);
    const double db = turn * scale * static_cast<double>(scan.inverse_bearing_sigma);
    ratio += (1.0 - share) * scale * scale * static_cast<double>(scan.gain * scan.worth[j]) *
             std::exp(-0.5 * (dr * dr + db * db));
    if (scan.inverse_resolution <= 0.0F) continue;
    const double apart =
        std::hypot(off, scan.detections[j].range * turn) * static_cast<double>(scan.inverse_resolution);
    merged = std::max(merged, share * std::exp2(-apart * apart));
  }
  return ratio + merged * (1.0 - ratio);
}

}  // namespace lookout::csht
