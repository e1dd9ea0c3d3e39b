#include "csht/likelihood/range_gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "csht/likelihood/fast_math.hpp"
#include "csht/likelihood/vector_clones.hpp"

namespace lookout::csht {
namespace {

// Farther from an end of the gate, fewer than 3 returns in 100,000 are lost.
constexpr float kFarSigmas = 4.0F;
constexpr double kNoTail = 8.0;  // In sigmas: 1e-15.

struct NearEnds {
  bool low, high;
};

LOOKOUT_VECTOR_CLONES
NearEnds near_ends(float low, float high, std::span<const float> range) {
  const float* values = range.data();
  const std::size_t count = range.size();
  int near_low = 0, near_high = 0;
  for (std::size_t i = 0; i < count; ++i) {
    near_low |= values[i] < low;
    near_high |= values[i] > high;
  }
  return {near_low != 0, near_high != 0};
}

LOOKOUT_VECTOR_CLONES
void find_tails_beyond(float max_range, float inverse_sigma, std::span<const float> range,
                       std::span<float> lost) {
  const float* from = range.data();
  float* to = lost.data();
  const std::size_t count = range.size();
  for (std::size_t i = 0; i < count; ++i) to[i] = fast_normal_tail((max_range - from[i]) * inverse_sigma);
}

LOOKOUT_VECTOR_CLONES
void add_tails_below(float inverse_sigma, std::span<const float> range, std::span<float> lost) {
  const float* from = range.data();
  float* to = lost.data();
  const std::size_t count = range.size();
  for (std::size_t i = 0; i < count; ++i) to[i] += fast_normal_tail(from[i] * inverse_sigma);
}

double normal_tail(double sigmas) {
  return sigmas > kNoTail ? 0.0 : 0.5 * std::erfc(sigmas / std::numbers::sqrt2);
}

}  // namespace

bool find_lost_shares(float max_range, float inverse_sigma, std::span<const float> range,
                      std::span<float> lost) {
  const float margin = kFarSigmas / inverse_sigma;
  const NearEnds near = near_ends(margin, max_range - margin, range);
  if (!near.low && !near.high) return false;
  find_tails_beyond(max_range, inverse_sigma, range, lost);
  if (near.low) add_tails_below(inverse_sigma, range, lost);
  return true;
}

LOOKOUT_VECTOR_CLONES
void add_range_loss(float loss, std::span<const float> range, std::span<float> lost, std::span<float> heard) {
  const float* from = range.data();
  float *to = lost.data(), *left = heard.data();
  const std::size_t count = range.size();
  for (std::size_t i = 0; i < count; ++i) {
    const float taken = loss * from[i] * from[i];
    left[i] = 1.0F - (taken < kMostRangeLoss ? taken : kMostRangeLoss);
    to[i] = 1.0F - (1.0F - to[i]) * left[i];
  }
}

double heard_share(double loss, double range) {
  return 1.0 - std::min(static_cast<double>(kMostRangeLoss), loss * range * range);
}

double lost_share(double max_range, double inverse_sigma, double range) {
  return normal_tail((max_range - range) * inverse_sigma) + normal_tail(range * inverse_sigma);
}

}  // namespace lookout::csht
