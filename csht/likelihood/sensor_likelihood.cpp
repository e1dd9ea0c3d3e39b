#include "csht/likelihood/sensor_likelihood.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "csht/likelihood/blurred_likelihood.hpp"
#include "csht/likelihood/fast_math.hpp"
#include "csht/likelihood/point_likelihood.hpp"
#include "csht/likelihood/range_gate.hpp"
#include "csht/likelihood/vector_clones.hpp"

namespace lookout::csht {
namespace {

constexpr std::size_t kBlock = 64;   // Hypotheses at a time: the block's arrays stay in the first cache.
constexpr std::size_t kFewNear = 4;  // Near an edge are few, if fewer than one in so many.
static_assert(kBlock <= kPointBlock);
using Lane = std::array<float, kBlock>;
constexpr float kTailExponent =
    static_cast<float>(-0.5 / (SensorFigures::kTailScale * SensorFigures::kTailScale));

// A slot's likelihood ratio as loaded for each hypothesis.
struct SlotLanes {
  Lane range, base, gain, mask_range, mask_share, mask_nearer;
};

// What a tolerance makes of a scan's Gaussian; wider is lower, so that it still averages 1 over clutter.
struct Shape {
  float gain, inverse_sigma;
  float tail;              // Height of the wider peak over that of the narrow one; 0: none.
  float inverse_softness;  // Slope of the neighbour's weight, half over edge_softness [1/beam].
};

Shape shape_of(const ScanTable& scan, const Tolerance& tolerance) {
  const auto scale = static_cast<float>(1.0 / tolerance.sigma_scale);
  return {scan.gain * scale, scan.inverse_sigma * scale, scan.tail_gain / scan.gain,
          static_cast<float>(0.5 / tolerance.edge_softness)};
}

struct Block {
  Shape shape;
  Lane range;    // From the sonar [m].
  Lane bearing;  // From the sector's middle [rad].
  Lane seen;     // 1 within the maximum range, else 0.
  Lane weight;   // Of the neighbour slot in the mixture at a beam edge.
  Lane lost;     // Probability that range takes the echo, or noise the return out of the gate; if `loses`.
  Lane heard;    // Probability that range leaves the echo; set only if `fades`.
  bool loses;    // Some of the hypotheses lose returns,
  bool fades;    // and some by range alone.
  std::array<int, kBlock> slot, neighbour;
  SlotLanes own, other;
  Lane ratio;
};

// Consecutive hypotheses of a span.
struct Part {
  std::size_t first, count;
};

// Where they are seen; as many places as the part has hypotheses.
struct Seen {
  float* range;    // From the sonar [m].
  float* bearing;  // From the sector's middle [rad].
};

LOOKOUT_VECTOR_CLONES
void place(const ScanTable& scan, const HypothesisSpan& h, Part part, double seconds, Seen seen) {
  const double north0 = scan.T_earth_sonar.north, east0 = scan.T_earth_sonar.east;
  const auto c = static_cast<float>(scan.cos_axis), s = static_cast<float>(scan.sin_axis);
  const double* north = h.north.data() + part.first;
  const double* east = h.east.data() + part.first;
  const double* north_velocity = h.north_velocity.data() + part.first;
  const double* east_velocity = h.east_velocity.data() + part.first;
  float *range = seen.range, *bearing = seen.bearing;
  for (std::size_t i = 0; i < part.count; ++i) {
    const auto dn = static_cast<float>(north[i] + north_velocity[i] * seconds - north0);
    const auto de = static_cast<float>(east[i] + east_velocity[i] * seconds - east0);
    range[i] = std::sqrt(dn * dn + de * de);
    bearing[i] = fast_atan2(c * de - s * dn, c * dn + s * de);
  }
}

// Bearings as they would be if the beams were even: from here on a beam is a mean step wide.
void even_out(const ScanTable& scan, std::size_t count, float* bearing) {
  for (std::size_t i = 0; i < count; ++i)
    bearing[i] =
        static_cast<float>(scan.beams_from_middle(static_cast<double>(bearing[i])) * scan.bearing_step);
}

// The slot of each hypothesis, the neighbour across its nearer edge, and the neighbour's weight: 1/2 at the
// edge, falling linearly to 0 at edge_softness. Out of range or sector: slot 0 of a sector, which says
// nothing.
LOOKOUT_VECTOR_CLONES
void find_slots(const ScanTable& scan, std::size_t count, Block& b) {
  const auto inverse_step = static_cast<float>(1.0 / scan.bearing_step);
  const auto max_range = static_cast<float>(scan.max_range);
  const float middle = 0.5F * static_cast<float>(scan.num_beams) + 1.0F;
  const float last = static_cast<float>(scan.num_beams) + 1.5F;
  const float inverse_softness = b.shape.inverse_softness;
  for (std::size_t i = 0; i < count; ++i) {
    float beam = b.bearing[i] * inverse_step + middle;
    beam = beam < 0.5F ? 0.5F : beam;
    beam = beam > last ? last : beam;
    const int slot = static_cast<int>(beam);
    const float inside = beam - static_cast<float>(slot);
    const float edge = inside < 0.5F ? inside : 1.0F - inside;
    const float weight = 0.5F - edge * inverse_softness;
    b.slot[i] = slot;
    b.neighbour[i] = inside < 0.5F ? slot - 1 : slot + 1;
    b.weight[i] = weight > 0.0F ? weight : 0.0F;
    b.seen[i] = b.range[i] <= max_range ? 1.0F : 0.0F;
  }
}

template <bool kMasked>
inline __attribute__((always_inline)) void load_one(const ScanTable& scan, const BeamMask* mask, int slots,
                                                    std::size_t i, const Block& b, SlotLanes& lanes) {
  const auto slot = static_cast<std::size_t>(std::clamp(slots, 0, scan.num_beams + 1));
  lanes.range[i] = scan.range[slot];
  lanes.gain[i] = b.shape.gain * scan.worth[slot] * (b.fades ? b.heard[i] : 1.0F);
  lanes.base[i] = b.loses ? scan.base[slot] + scan.lost[slot] * b.lost[i] : scan.base[slot];
  if constexpr (kMasked) {
    lanes.mask_range[i] = mask->range[slot];
    lanes.mask_share[i] = mask->share[slot];
    lanes.mask_nearer[i] = mask->nearer[slot];
  }
}

template <bool kMasked, bool kTailed>
inline __attribute__((always_inline)) float slot_ratio(const Shape& shape, const SlotLanes& lanes,
                                                       float range, std::size_t i) {
  const float offset = (range - lanes.range[i]) * shape.inverse_sigma;
  float peak = fast_exp(-0.5F * offset * offset);
  if constexpr (kTailed) peak += shape.tail * fast_exp(kTailExponent * offset * offset);
  const float ratio = lanes.base[i] + lanes.gain[i] * peak;
  if constexpr (!kMasked) return ratio;
  const float share = lanes.mask_share[i];
  return range > lanes.mask_range[i] ? share + (1.0F - share) * ratio : ratio * lanes.mask_nearer[i];
}

template <bool kMasked, bool kTailed>
inline __attribute__((always_inline)) void score_own(std::size_t count, Block& b) {
  const Shape shape = b.shape;
  for (std::size_t i = 0; i < count; ++i)
    b.ratio[i] = slot_ratio<kMasked, kTailed>(shape, b.own, b.range[i], i);
}

template <bool kMasked, bool kTailed>
inline __attribute__((always_inline)) void mix_neighbours(std::size_t count, Block& b) {
  const Shape shape = b.shape;
  for (std::size_t i = 0; i < count; ++i)
    b.ratio[i] += b.weight[i] * (slot_ratio<kMasked, kTailed>(shape, b.other, b.range[i], i) - b.ratio[i]);
}

LOOKOUT_VECTOR_CLONES
void score_own_free(std::size_t count, Block& b) {
  score_own<false, false>(count, b);
}
LOOKOUT_VECTOR_CLONES
void score_own_masked(std::size_t count, Block& b) {
  score_own<true, false>(count, b);
}
LOOKOUT_VECTOR_CLONES
void score_own_tailed(std::size_t count, bool masked, Block& b) {
  masked ? score_own<true, true>(count, b) : score_own<false, true>(count, b);
}
LOOKOUT_VECTOR_CLONES
void mix_neighbours_free(std::size_t count, Block& b) {
  mix_neighbours<false, false>(count, b);
}
LOOKOUT_VECTOR_CLONES
void mix_neighbours_masked(std::size_t count, Block& b) {
  mix_neighbours<true, false>(count, b);
}
LOOKOUT_VECTOR_CLONES
void mix_neighbours_tailed(std::size_t count, bool masked, Block& b) {
  masked ? mix_neighbours<true, true>(count, b) : mix_neighbours<false, true>(count, b);
}

LOOKOUT_VECTOR_CLONES
void forget_out_of_view(std::size_t count, Block& b) {
  for (std::size_t i = 0; i < count; ++i) b.ratio[i] = b.seen[i] > 0.5F ? b.ratio[i] : 1.0F;
}

template <bool kMasked, bool kTailed>
void mix_all(std::size_t count, Block& b) {
  if constexpr (kTailed)
    mix_neighbours_tailed(count, kMasked, b);
  else
    kMasked ? mix_neighbours_masked(count, b) : mix_neighbours_free(count, b);
}

// Where edges are hardly softened, few hypotheses are near one: those alone are mixed, one by one.
template <bool kMasked, bool kTailed>
void score_slots(const ScanTable& scan, const BeamMask* mask, std::size_t count, Block& b) {
  for (std::size_t i = 0; i < count; ++i) load_one<kMasked>(scan, mask, b.slot[i], i, b, b.own);
  if constexpr (kTailed)
    score_own_tailed(count, kMasked, b);
  else
    kMasked ? score_own_masked(count, b) : score_own_free(count, b);
  std::array<std::uint8_t, kBlock> near;
  std::size_t num_near = 0;
  for (std::size_t i = 0; i < count; ++i) {
    near[num_near] = static_cast<std::uint8_t>(i);
    num_near += b.weight[i] > 0.0F ? 1 : 0;
  }
  const bool few = kFewNear * num_near < count;
  for (std::size_t k = 0; k < (few ? num_near : count); ++k) {
    const std::size_t i = few ? near[k] : k;
    load_one<kMasked>(scan, mask, b.neighbour[i], i, b, b.other);
    if (!few) continue;
    b.ratio[i] += b.weight[i] * (slot_ratio<kMasked, kTailed>(b.shape, b.other, b.range[i], i) - b.ratio[i]);
  }
  if (!few) mix_all<kMasked, kTailed>(count, b);
  forget_out_of_view(count, b);
}

void find_losses(const ScanTable& scan, std::size_t count, Block& b) {
  const std::span<const float> range(b.range.data(), count);
  const std::span<float> lost(b.lost.data(), count);
  b.loses = scan.range_gate &&
            find_lost_shares(static_cast<float>(scan.max_range), b.shape.inverse_sigma, range, lost);
  b.fades = scan.range_loss > 0.0F;
  if (!b.fades) return;
  if (!b.loses) std::fill(lost.begin(), lost.end(), 0.0F);
  add_range_loss(scan.range_loss, range, lost, {b.heard.data(), count});
  b.loses = true;
}

void score_beams(const ScanTable& scan, const BeamMask* mask, std::size_t count, Block& b) {
  find_slots(scan, count, b);
  find_losses(scan, count, b);
  const bool tailed = b.shape.tail > 0.0F;
  if (mask == nullptr)
    tailed ? score_slots<false, true>(scan, mask, count, b) : score_slots<false, false>(scan, mask, count, b);
  else
    tailed ? score_slots<true, true>(scan, mask, count, b) : score_slots<true, false>(scan, mask, count, b);
}

LOOKOUT_VECTOR_CLONES
void add_logs(std::size_t count, const Block& b, double* log_ratio) {
  for (std::size_t i = 0; i < count; ++i) log_ratio[i] += static_cast<double>(fast_log(b.ratio[i]));
}

LOOKOUT_VECTOR_CLONES
void multiply(std::size_t count, const Block& b, double* product) {
  for (std::size_t i = 0; i < count; ++i) product[i] *= static_cast<double>(b.ratio[i]);
}

// The ratios of all hypotheses, block by block, each block handed to `use(count, block, first)`.
template <typename Use>
void for_each_block(const ScanTable& scan, const BeamMask* mask, const HypothesisSpan& hypotheses,
                    double seconds, const Tolerance& tolerance, Use use) {
  if (mask != nullptr && mask->empty) mask = nullptr;
  Block block;
  block.shape = shape_of(scan, tolerance);
  for (std::size_t first = 0; first < hypotheses.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, hypotheses.size() - first);
    place(scan, hypotheses, {first, count}, seconds, {block.range.data(), block.bearing.data()});
    if (scan.uneven()) even_out(scan, count, block.bearing.data());
    if (scan.clutter == ClutterModel::point)
      find_point_ratios(scan, mask, {block.range.data(), count}, {block.bearing.data(), count}, tolerance,
                        {block.ratio.data(), count});
    else if (scan.blur_reach > 0)
      find_blurred_ratios(scan, mask, {block.range.data(), count}, {block.bearing.data(), count}, tolerance,
                          {block.ratio.data(), count});
    else
      score_beams(scan, mask, count, block);
    use(count, block, first);
  }
}

double plain_slot_ratio(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance,
                        int slot_index, double range) {
  const auto slot = static_cast<std::size_t>(std::clamp(slot_index, 0, scan.num_beams + 1));
  const double ratio = scan.base[slot] +
                       scan.lost[slot] * lost_of(scan, scan.inverse_sigma / tolerance.sigma_scale, range) +
                       peak_of(scan, slot, range, tolerance.sigma_scale);
  if (mask == nullptr) return ratio;
  const double share = mask->share[slot];
  return range > mask->range[slot] ? share + (1.0 - share) * ratio : ratio * mask->nearer[slot];
}

double plain_beam_ratio(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance, double range,
                        double bearing) {
  const double beam =
      std::clamp(scan.beams_from_middle(bearing) + 0.5 * scan.num_beams + 1.0, 0.5, scan.num_beams + 1.5);
  const int slot = static_cast<int>(beam);
  const double inside = beam - slot;
  const double edge = std::min(inside, 1.0 - inside);
  const double weight = std::max(0.0, 0.5 - 0.5 * edge / tolerance.edge_softness);
  const int neighbour = inside < 0.5 ? slot - 1 : slot + 1;
  return (1.0 - weight) * plain_slot_ratio(scan, mask, tolerance, slot, range) +
         weight * plain_slot_ratio(scan, mask, tolerance, neighbour, range);
}

}  // namespace

void locate(const ScanTable& scan, const HypothesisSpan& hypotheses, double seconds, std::span<float> range,
            std::span<float> bearing) {
  place(scan, hypotheses, {0, hypotheses.size()}, seconds, {range.data(), bearing.data()});
  if (scan.uneven()) even_out(scan, hypotheses.size(), bearing.data());
}

void add_log_ratio(const ScanTable& scan, const BeamMask* mask, const HypothesisSpan& hypotheses,
                   double seconds, const Tolerance& tolerance, std::span<double> log_ratio) {
  for_each_block(scan, mask, hypotheses, seconds, tolerance,
                 [&](std::size_t count, const Block& block, std::size_t first) {
                   add_logs(count, block, log_ratio.data() + first);
                 });
}

void multiply_by_ratio(const ScanTable& scan, const BeamMask* mask, const HypothesisSpan& hypotheses,
                       double seconds, const Tolerance& tolerance, std::span<double> product) {
  for_each_block(scan, mask, hypotheses, seconds, tolerance,
                 [&](std::size_t count, const Block& block, std::size_t first) {
                   multiply(count, block, product.data() + first);
                 });
}

LOOKOUT_VECTOR_CLONES
void add_births(double log_birth, std::span<double> log_ratio) {
  if (log_birth == -std::numeric_limits<double>::infinity()) return;
  double* values = log_ratio.data();
  const std::size_t count = log_ratio.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double value = values[i];
    const double high = value < log_birth ? log_birth : value;
    const double low = value < log_birth ? value : log_birth;
    values[i] = high + static_cast<double>(fast_log(1.0F + fast_exp(static_cast<float>(low - high))));
  }
}

double log_ratio(const ScanTable& scan, const BeamMask* mask, const Eigen::Vector2d& p_earth,
                 const Tolerance& tolerance) {
  if (mask != nullptr && mask->empty) mask = nullptr;
  const double dn = p_earth.x() - scan.T_earth_sonar.north, de = p_earth.y() - scan.T_earth_sonar.east;
  const double range = std::hypot(dn, de);
  if (range > scan.max_range) return 0.0;
  if (scan.blur_reach > 0) return blurred_log_ratio(scan, mask, p_earth, tolerance);
  const double bearing = core::wrap_to_pi(std::atan2(de, dn) - scan.axis);
  const double ratio = scan.clutter == ClutterModel::point
                           ? plain_point_ratio(scan, mask, range, bearing, tolerance)
                           : plain_beam_ratio(scan, mask, tolerance, range, bearing);
  return std::log(ratio);
}

}  // namespace lookout::csht
