#pragma once

#include <vector>

#include "core/detection.hpp"
#include "core/sonar_scan.hpp"

namespace lookout::csht {

/// Places the returns of one scan in the earth frame, in the order of the scan. Returns with a range outside
/// (0, max_range] or a value that is not finite are left out. [Yan2018] Eq. (1)-(3).
/// @param scan_index the index of the scan in its window, copied to each detection.
/// @param detections is overwritten; its capacity is kept, so that a warm caller allocates nothing.
/// @return how many returns were left out.
int scan_to_detections(const core::PosedScan& scan, int scan_index, std::vector<core::Detection>& detections);

}  // namespace lookout::csht
