#pragma once

#include <string>

#include "tools/import/import_summary.hpp"

namespace lookout::tools {

/// Makes a recording of a file pair of the Autoferry data set (github.com/Autoferry/sensor_fusion_dataset):
/// the radar's scans alone, time 0 the first of them, heading 0 (bearings are from north), the truth that
/// stands beside each scan, its velocity the difference from scan to scan (0 in a target's first row:
/// unknown). Returns and targets that are not finite, a second scan of one time and scans behind the end of
/// the truth are left out and counted, by reason.
/// @param out recording directory, made where it is not.
/// @throws core::InputError naming file and entry that is not as the data set has it: then nothing is
/// written.
ImportSummary import_autoferry(const std::string& detections, const std::string& ground_truth,
                               const std::string& out);

}  // namespace lookout::tools
