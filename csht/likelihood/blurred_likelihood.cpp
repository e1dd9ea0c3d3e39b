#include "csht/likelihood/blurred_likelihood.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "csht/likelihood/fast_math.hpp"
#include "csht/likelihood/range_gate.hpp"
#include "csht/likelihood/vector_clones.hpp"

namespace lookout::csht {
namespace {

using Lane = std::array<float, kBlurBlock>;

// The normal distribution function as a logistic one, within 0.01 everywhere: the slope of its exponent.
constexpr float kLogisticSlope = 1.702F;
constexpr float kTailExponent =
    static_cast<float>(-0.5 / (SensorFigures::kTailScale * SensorFigures::kTailScale));
constexpr float kLeastRange = 0.1F;  // [m]; nearer, a position error turns the bearing all around.

struct SlotLanes {
  Lane range, base, gain, mask_range, mask_share, mask_nearer;
};

struct Block {
  float gain, inverse_sigma;
  float tail;      // Height of the wider peak over that of the narrow one; 0: none.
  Lane range;      // From the sonar [m].
  Lane beam;       // Where the stated pose puts the target, in slots and parts of one.
  Lane steepness;  // Of the logistic function over beams.
  Lane below;      // Share of the slots passed so far.
  Lane mixed;      // Their part of the likelihood ratio.
  Lane lost;       // Probability that range takes the echo, or noise the return out of the gate.
  Lane heard;      // Probability that range leaves the echo.
  std::array<int, kBlurBlock> slot;
  SlotLanes lanes;
};

// Variance of an edge that is soft over +-softness beams, as a part of the blur [beams^2].
float soft_variance(const Tolerance& tolerance) {
  return static_cast<float>(tolerance.edge_softness * tolerance.edge_softness / 3.0);
}

LOOKOUT_VECTOR_CLONES
void start(const ScanTable& scan, const float* range, const float* bearing, std::size_t count, float softness,
           Block& b) {
  const auto inverse_step = static_cast<float>(1.0 / scan.bearing_step);
  const auto reach = static_cast<float>(scan.blur_reach), beams = static_cast<float>(scan.num_beams);
  const float low = -reach, high = beams + 2.0F + reach;
  const float heading = scan.blur_heading * scan.blur_heading + softness;
  for (std::size_t i = 0; i < count; ++i) {
    const float beam = bearing[i] * inverse_step + 0.5F * beams + 1.0F;
    const float lever = scan.blur_position / (range[i] < kLeastRange ? kLeastRange : range[i]);
    b.range[i] = range[i];
    b.beam[i] = beam < low ? low : (beam > high ? high : beam);
    b.steepness[i] = kLogisticSlope / std::sqrt(heading + lever * lever);
    b.below[i] = 0.0F;
    b.mixed[i] = 0.0F;
  }
}

// An error of the pose goes over more of the narrow beams than of the wide ones.
void spread_by_width(const ScanTable& scan, std::size_t count, float softness, Block& b) {
  const double middle = 0.5 * scan.num_beams + 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto wider =
        static_cast<float>(scan.bearing_step / scan.width_at(static_cast<double>(b.beam[i]) - middle));
    const float lever = scan.blur_position / std::max(b.range[i], kLeastRange);
    const float heading = scan.blur_heading;
    b.steepness[i] =
        kLogisticSlope / std::sqrt(wider * wider * (heading * heading + lever * lever) + softness);
  }
}

// The slot for any beam number: around the whole circle the numbers repeat; outside a sector it is the first
// or the last.
int slot_of(const ScanTable& scan, int slot) {
  if (!scan.whole_circle) return std::clamp(slot, 0, scan.num_beams + 1);
  const int beam = (slot - 1) % scan.num_beams;
  return (beam < 0 ? beam + scan.num_beams : beam) + 1;
}

template <bool kMasked>
void load(const ScanTable& scan, const BeamMask* mask, int offset, std::size_t count, Block& b) {
  for (std::size_t i = 0; i < count; ++i) {
    b.slot[i] = static_cast<int>(std::floor(b.beam[i])) + offset;
    const auto slot = static_cast<std::size_t>(slot_of(scan, b.slot[i]));
    b.lanes.range[i] = scan.range[slot];
    b.lanes.gain[i] = b.gain * scan.worth[slot] * b.heard[i];
    b.lanes.base[i] = scan.base[slot] + scan.lost[slot] * b.lost[i];
    if constexpr (kMasked) {
      b.lanes.mask_range[i] = mask->range[slot];
      b.lanes.mask_share[i] = mask->share[slot];
      b.lanes.mask_nearer[i] = mask->nearer[slot];
    }
  }
}

inline __attribute__((always_inline)) float plain_ratio(const Block& b, std::size_t i) {
  const float offset = (b.range[i] - b.lanes.range[i]) * b.inverse_sigma;
  float peak = fast_exp(-0.5F * offset * offset);
  if (b.tail > 0.0F) peak += b.tail * fast_exp(kTailExponent * offset * offset);
  return b.lanes.base[i] + b.lanes.gain[i] * peak;
}

inline __attribute__((always_inline)) float masked_ratio(const Block& b, std::size_t i) {
  const float ratio = plain_ratio(b, i), share = b.lanes.mask_share[i];
  return b.range[i] > b.lanes.mask_range[i] ? share + (1.0F - share) * ratio : ratio * b.lanes.mask_nearer[i];
}

// Adds the loaded slots' part to the mean; their probability is what the distribution function gains over
// them.
template <bool kMasked>
inline __attribute__((always_inline)) void mix_slot(std::size_t count, bool last, Block& b) {
  for (std::size_t i = 0; i < count; ++i) {
    const float edge = static_cast<float>(b.slot[i] + 1) - b.beam[i];
    const float up_to = last ? 1.0F : 1.0F / (1.0F + fast_exp(-b.steepness[i] * edge));
    const float ratio = kMasked ? masked_ratio(b, i) : plain_ratio(b, i);
    b.mixed[i] += (up_to - b.below[i]) * ratio;
    b.below[i] = up_to;
  }
}

LOOKOUT_VECTOR_CLONES
void mix_free(std::size_t count, bool last, Block& b) {
  mix_slot<false>(count, last, b);
}

LOOKOUT_VECTOR_CLONES
void mix_masked(std::size_t count, bool last, Block& b) {
  mix_slot<true>(count, last, b);
}

// Where the stated pose puts one position.
struct Placed {
  double range, beam, spread;  // [m], in slots and parts of one, standard deviation in beams.
};

Placed place(const ScanTable& scan, const Eigen::Vector2d& p_earth, const Tolerance& tolerance) {
  const double dn = p_earth.x() - scan.T_earth_sonar.north, de = p_earth.y() - scan.T_earth_sonar.east;
  const double range = std::hypot(dn, de);
  const double bearing = core::wrap_to_pi(std::atan2(de, dn) - scan.axis);
  const double from_middle = scan.beams_from_middle(bearing);
  const double beam = from_middle + 0.5 * scan.num_beams + 1.0;
  const double wider = scan.bearing_step / scan.width_at(from_middle);
  const double lever =
      wider * static_cast<double>(scan.blur_position) / std::max(range, static_cast<double>(kLeastRange));
  const auto heading = wider * static_cast<double>(scan.blur_heading);
  return {range, std::clamp(beam, -1.0 * scan.blur_reach, scan.num_beams + 2.0 + scan.blur_reach),
          std::sqrt(heading * heading + lever * lever + static_cast<double>(soft_variance(tolerance)))};
}

double slot_ratio(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance, int number,
                  double range) {
  const auto slot = static_cast<std::size_t>(slot_of(scan, number));
  const double inverse_sigma = static_cast<double>(scan.inverse_sigma) / tolerance.sigma_scale;
  const double ratio = static_cast<double>(scan.base[slot]) +
                       static_cast<double>(scan.lost[slot]) * lost_of(scan, inverse_sigma, range) +
                       peak_of(scan, slot, range, tolerance.sigma_scale);
  if (mask == nullptr) return ratio;
  const auto share = static_cast<double>(mask->share[slot]);
  return range > static_cast<double>(mask->range[slot]) ? share + (1.0 - share) * ratio
                                                        : ratio * static_cast<double>(mask->nearer[slot]);
}

// Calls `take(slot, probability)` for every slot in reach, before the scan is known.
template <class Take>
void for_each_slot(const ScanTable& scan, const Placed& placed, const Take& take) {
  double below = 0.0;
  for (int k = -scan.blur_reach; k <= scan.blur_reach; ++k) {
    const int slot = static_cast<int>(std::floor(placed.beam)) + k;
    const double edge = (slot + 1 - placed.beam) / placed.spread;
    const double up_to =
        k == scan.blur_reach ? 1.0 : 1.0 / (1.0 + std::exp(-static_cast<double>(kLogisticSlope) * edge));
    take(slot, up_to - below);
    below = up_to;
  }
}

}  // namespace

void find_blurred_ratios(const ScanTable& scan, const BeamMask* mask, std::span<const float> range,
                         std::span<const float> bearing, const Tolerance& tolerance, std::span<float> ratio) {
  assert(range.size() <= kBlurBlock);
  const auto scale = static_cast<float>(1.0 / tolerance.sigma_scale);
  const std::size_t count = range.size();
  Block block;
  block.gain = scan.gain * scale;
  block.inverse_sigma = scan.inverse_sigma * scale;
  block.tail = scan.tail_gain / scan.gain;
  if (!scan.range_gate ||
      !find_lost_shares(static_cast<float>(scan.max_range), block.inverse_sigma, range, block.lost))
    std::fill_n(block.lost.begin(), count, 0.0F);
  add_range_loss(scan.range_loss, range, {block.lost.data(), count}, {block.heard.data(), count});
  start(scan, range.data(), bearing.data(), count, soft_variance(tolerance), block);
  if (scan.uneven()) spread_by_width(scan, count, soft_variance(tolerance), block);
  for (int k = -scan.blur_reach; k <= scan.blur_reach; ++k) {
    const bool last = k == scan.blur_reach;
    if (mask == nullptr) {
      load<false>(scan, mask, k, count, block);
      mix_free(count, last, block);
    } else {
      load<true>(scan, mask, k, count, block);
      mix_masked(count, last, block);
    }
  }
  const auto max_range = static_cast<float>(scan.max_range);
  for (std::size_t i = 0; i < count; ++i) ratio[i] = range[i] <= max_range ? block.mixed[i] : 1.0F;
}

double blurred_log_ratio(const ScanTable& scan, const BeamMask* mask, const Eigen::Vector2d& p_earth,
                         const Tolerance& tolerance) {
  const Placed placed = place(scan, p_earth, tolerance);
  if (placed.range > scan.max_range) return 0.0;
  double ratio = 0.0;
  for_each_slot(scan, placed, [&](int slot, double probability) {
    ratio += probability * slot_ratio(scan, mask, tolerance, slot, placed.range);
  });
  return std::log(ratio);
}

BeamShares beam_shares(const ScanTable& scan, const Eigen::Vector2d& p_earth, const Tolerance& tolerance) {
  const Placed placed = place(scan, p_earth, tolerance);
  BeamShares shares;
  double total = 0.0;
  for_each_slot(scan, placed, [&](int slot, double probability) {
    const double weight = probability * slot_ratio(scan, nullptr, tolerance, slot, placed.range);
    const auto k = static_cast<std::size_t>(shares.count++);
    shares.beam[k] = slot_of(scan, slot) - 1;
    shares.share[k] = weight;
    total += weight;
  });
  for (int k = 0; k < shares.count; ++k) shares.share[static_cast<std::size_t>(k)] /= total;
  return shares;
}

}  // namespace lookout::csht
