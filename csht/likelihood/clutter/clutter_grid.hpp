#pragma once

#include "core/clutter_grid.hpp"
#include "csht/likelihood/clutter/clutter_map.hpp"

namespace lookout::csht {

/// The clutter map as a person can look at it: around the sonar of `newest`, in at most 60 x 50 cells, each
/// with the densest place that a return in memory came from. @param rate as for ClutterMap::price.
core::ClutterGrid clutter_grid(const ClutterMap& map, const ScanTable& newest, double rate);

}  // namespace lookout::csht
