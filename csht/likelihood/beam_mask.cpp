#include "csht/likelihood/beam_mask.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {
namespace {

float ratio_at(const ScanTable& table, std::size_t slot, float range) {
  const double at = static_cast<double>(range);
  return table.base[slot] +
         table.lost[slot] * static_cast<float>(lost_of(table, static_cast<double>(table.inverse_sigma), at)) +
         static_cast<float>(peak_of(table, slot, at));
}

}  // namespace

void BeamMask::clear(const ScanTable& table) {
  const std::size_t size =
      table.clutter == ClutterModel::point ? table.detections.size() : table.range.size();
  range.assign(size, std::numeric_limits<float>::max());
  share.assign(size, 0.0F);
  nearer.assign(size, 1.0F);
  empty = true;
}

void claim_beam(const ScanTable& table, int beam, double range, double share, BeamMask& mask) {
  if (beam < 0 || beam >= table.num_beams) return;
  const std::size_t slot = static_cast<std::size_t>(beam) + 1;
  mask.empty = false;
  mask.range[slot] = std::min(mask.range[slot], static_cast<float>(range));
  mask.share[slot] = 1.0F - (1.0F - mask.share[slot]) * (1.0F - static_cast<float>(share));
  mask.nearer[slot] = 1.0F - mask.share[slot] + mask.share[slot] / ratio_at(table, slot, mask.range[slot]);
}

void claim_detection(std::size_t index, double share, BeamMask& mask) {
  mask.empty = false;
  mask.share[index] = 1.0F - (1.0F - mask.share[index]) * (1.0F - static_cast<float>(share));
}

}  // namespace lookout::csht
