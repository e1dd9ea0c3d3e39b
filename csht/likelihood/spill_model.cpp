#include "csht/likelihood/spill_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr double kUnknownSpill = 0.5;   // Probability before anything is learnt,
constexpr double kUnknownWeight = 4.0;  // with the weight of so many echoes.
constexpr double kLeastSpill = 0.02;    // Nothing is quite impossible.

std::size_t slot_of(int beam) {
  return static_cast<std::size_t>(beam) + 1;
}

}  // namespace

void validate(const SpillParams& p) {
  core::require(p.memory_scans > 1.0, "memory_scans must be > 1", p.memory_scans);
  core::require(p.range_gate > 0.0, "range_gate must be > 0", p.range_gate);
  core::require_inner_share("least_real", p.least_real);
  core::require_not_negative("doubt_sigmas", p.doubt_sigmas);
}

double SpillModel::real_share(int offset) const {
  const Offset& o = offsets_[static_cast<std::size_t>(offset)];
  const double real = (o.hits - o.chance - params_.doubt_sigmas * std::sqrt(o.chance + 1.0)) / (o.hits + 1.0);
  return real >= params_.least_real ? real : 0.0;
}

double SpillModel::probability(int offset) const {
  const Offset& o = offsets_[static_cast<std::size_t>(offset)];
  return (o.heard + kUnknownWeight * kUnknownSpill) / (o.echoes + kUnknownWeight);
}

bool SpillModel::coincide(const ScanTable& scan, int a, int b) const {
  if (scan.silent(a) || scan.silent(b)) return false;
  return std::abs(scan.range[slot_of(a)] - scan.range[slot_of(b)]) * scan.inverse_sigma <=
         static_cast<float>(params_.range_gate);
}

void SpillModel::learn(const ScanTable& scan, double false_alarm, std::span<const float> background) {
  if (!params_.enabled || scan.clutter == ClutterModel::point) return;
  const double kept = 1.0 - 1.0 / params_.memory_scans;
  const double gate = params_.range_gate / static_cast<double>(scan.inverse_sigma);
  const double by_chance = false_alarm * std::min(1.0, 2.0 * gate / scan.max_range);
  for (int d = 1; d <= kReach; ++d) {
    Offset& offset = offsets_[static_cast<std::size_t>(d)];
    for (double* value : {&offset.hits, &offset.chance, &offset.heard, &offset.echoes}) *value *= kept;
    for (int beam = 0; beam + d < scan.num_beams; ++beam) {
      if (scan.silent(beam)) continue;
      // Chance neighbours come 1 / background times as densely, and count by as much less.
      const auto own = static_cast<double>(background[slot_of(beam)]);
      offset.chance += by_chance * own;
      if (coincide(scan, beam, beam + d))
        offset.hits += own * static_cast<double>(background[slot_of(beam + d)]);
    }
  }
  learn_shares(scan, background);
}

// One step of expectation maximisation: each return of a group is the echo's own beam with its share, and
// what the beams beside it report then tells how far echoes spill.
void SpillModel::learn_shares(const ScanTable& scan, std::span<const float> background) {
  if (!active()) return;
  find_groups(scan, background, groups_);
  for (const Group& group : groups_) {
    for (int k = 0; k < group.size; ++k) {
      const auto i = static_cast<std::size_t>(k);
      for (int d = -kReach; d <= kReach; ++d) {
        const int other = group.beam[i] + d;
        if (d == 0 || other < 0 || other >= scan.num_beams) continue;
        Offset& offset = offsets_[static_cast<std::size_t>(std::abs(d))];
        const double own = group.real * group.origin[i];
        offset.echoes += own;
        if (group.holds(other)) offset.heard += own;
      }
    }
  }
}

// Real neighbours are equally likely everywhere; those of chance go with the density of clutter, and each
// neighbour is a coincidence of its own.
double SpillModel::real_of(const Group& group, std::span<const float> background) const {
  double log_background = 0.0;
  for (int k = 0; k < group.size; ++k)
    log_background +=
        std::log(static_cast<double>(background[slot_of(group.beam[static_cast<std::size_t>(k)])]));
  const double real = real_share(1);
  const double log_odds = std::log(real / (1.0 - real)) + log_background / group.size;
  return 1.0 / (1.0 + std::exp(-log_odds * (group.size - 1)));
}

bool SpillModel::Group::holds(int other) const {
  return std::find(beam.begin(), beam.begin() + size, other) != beam.begin() + size;
}

// Groups of at least two returns, none in two groups.
void SpillModel::find_groups(const ScanTable& scan, std::span<const float> background,
                             std::vector<Group>& groups) const {
  groups.clear();
  taken_.assign(static_cast<std::size_t>(scan.num_beams), 0);
  for (int first = 0; first < scan.num_beams; ++first) {
    if (scan.silent(first) || taken_[static_cast<std::size_t>(first)] != 0) continue;
    Group group = group_from(scan, first);
    for (int k = 0; k < group.size; ++k)
      taken_[static_cast<std::size_t>(group.beam[static_cast<std::size_t>(k)])] = 1;
    if (group.size < 2 || group.size > kMostBeams || groups.size() == kMostGroups) continue;
    weigh_origins(scan, group);
    group.real = real_of(group, background);
    groups.push_back(group);
  }
}

// Beams that follow each other without a gap wider than the spill reaches, each at nearly the range of the
// one before it. Where they are more than an echo can be, the rest stays for another group.
SpillModel::Group SpillModel::group_from(const ScanTable& scan, int first) const {
  Group group;
  group.beam[0] = first;
  group.size = 1;
  int last = first;
  for (int beam = first + 1; beam < scan.num_beams && beam - last <= kReach && group.size <= kMostBeams;
       ++beam) {
    if (taken_[static_cast<std::size_t>(beam)] != 0 || real_share(beam - last) <= 0.0) continue;
    if (!coincide(scan, last, beam)) continue;
    group.beam[static_cast<std::size_t>(group.size++)] = last = beam;
  }
  return group;
}

void SpillModel::weigh_origins(const ScanTable& scan, Group& group) const {
  double total = 0.0;
  for (int k = 0; k < group.size; ++k) {
    const auto i = static_cast<std::size_t>(k);
    total += group.origin[i] = origin_weight(scan, group, group.beam[i]);
  }
  for (double& origin : group.origin) origin /= total;
}

// How probable the group is if the echo was in this beam: which of its neighbours hear it, and which do not.
double SpillModel::origin_weight(const ScanTable& scan, const Group& group, int beam) const {
  double weight = 1.0;
  for (int d = -kReach; d <= kReach; ++d) {
    const int other = beam + d;
    if (d == 0 || other < 0 || other >= scan.num_beams) continue;
    const double heard = std::clamp(probability(std::abs(d)), kLeastSpill, 1.0 - kLeastSpill);
    weight *= group.holds(other) ? heard : 1.0 - heard;
  }
  for (int k = 0; k < group.size; ++k)
    if (std::abs(group.beam[static_cast<std::size_t>(k)] - beam) > kReach) weight *= kLeastSpill;
  return weight;
}

void SpillModel::group(std::span<const float> background, ScanTable& scan) const {
  std::fill(scan.share.begin(), scan.share.end(), 1.0F);
  std::fill(scan.group.begin(), scan.group.end(), std::int16_t{-1});
  std::fill(scan.echo_offset.begin(), scan.echo_offset.end(), 0.0F);
  if (!params_.enabled || scan.clutter == ClutterModel::point || !active()) return;
  find_groups(scan, background, groups_);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    double mean = 0.0;
    for (int k = 0; k < group.size; ++k)
      mean += group.origin[static_cast<std::size_t>(k)] * group.beam[static_cast<std::size_t>(k)];
    for (int k = 0; k < group.size; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (group.real > 0.5)
        scan.echo_offset[slot_of(group.beam[i])] = static_cast<float>(mean - group.beam[i]);
      scan.group[slot_of(group.beam[i])] = static_cast<std::int16_t>(g);
      scan.share[slot_of(group.beam[i])] =
          static_cast<float>(1.0 - group.real + group.real * group.origin[i]);
    }
  }
  if (!scan.whole_circle) return;
  scan.share.front() = scan.share[slot_of(scan.num_beams - 1)];
  scan.share.back() = scan.share[slot_of(0)];
}

}  // namespace lookout::csht
