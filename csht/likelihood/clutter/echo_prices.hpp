#pragma once

#include <vector>

#include "csht/likelihood/clutter/clutter_map.hpp"
#include "csht/likelihood/spill_model.hpp"

namespace lookout::csht {

/// How many false returns the uniform background makes.
struct BackgroundRate {
  double of_scan = 9.0;  ///< Mean number of a scan, > 0.
  double of_beam = 0.1;  ///< P_F of a beam, in (0, 1].
};

/// Prices the newest scan where echoes may be heard in several beams, and learns from it how they are.
/// Neighbours are first taken for one echo, and priced at its place: by their own places the trail of an echo
/// that spills would pass for dense clutter. @param group groups the scan's returns by `spill` and
/// `background` (SpillModel::group).
/// @param background filled as by ClutterMap::price. @return whether echoes spill: then the groups are to be
/// made anew by these prices.
template <class Group>
bool price_echoes(const ScanTable& newest, const BackgroundRate& rate, ClutterMap& map, SpillModel& spill,
                  const Group& group, std::vector<float>& background) {
  background.assign(newest.background.size(), 1.0F);
  const bool spilt = spill.active();
  group();
  map.price(newest, rate.of_scan, background);
  spill.learn(newest, rate.of_beam, background);
  if (!spilt && !spill.active()) return false;
  group();
  map.price(newest, rate.of_scan, background);
  return true;
}

}  // namespace lookout::csht
