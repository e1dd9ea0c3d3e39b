#include "csht/range_gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "csht/fast_math.hpp"
#include "csht/vector_clones.hpp"

namespace lookout::csht {
namespace {

constexpr float kFarSigmas = 4.0F;  // From an end of the gate, beyond which 3 echoes of 100,000 are lost.

LOOKOUT_VECTOR_CLONES
bool any_near_an_end(float low, float high, std::span<const float> range) {
  const float* values = range.data();
  const std::size_t count = range.size();
  int near = 0;
  for (std::size_t i = 0; i < count; ++i) near |= static_cast<int>(values[i] < low) | (values[i] > high);
  return near != 0;
}

LOOKOUT_VECTOR_CLONES
void add_tails(float max_range, float inverse_sigma, std::span<const float> range, std::span<float> lost) {
  const float* from = range.data();
  float* to = lost.data();
  const std::size_t count = range.size();
  for (std::size_t i = 0; i < count; ++i)
    to[i] =
        fast_normal_tail((max_range - from[i]) * inverse_sigma) + fast_normal_tail(from[i] * inverse_sigma);
}

double normal_tail(double sigmas) {
  return 0.5 * std::erfc(sigmas / std::numbers::sqrt2);
}

}  // namespace

bool find_lost_shares(float max_range, float inverse_sigma, std::span<const float> range,
                      std::span<float> lost) {
  const float margin = kFarSigmas / inverse_sigma;
  if (!any_near_an_end(margin, max_range - margin, range)) return false;
  add_tails(max_range, inverse_sigma, range, lost);
  return true;
}

double lost_share(double max_range, double inverse_sigma, double range) {
  return normal_tail((max_range - range) * inverse_sigma) + normal_tail(range * inverse_sigma);
}

}  // namespace lookout::csht
