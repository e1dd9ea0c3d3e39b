#pragma once

#include <cstdint>
#include <string>

#include "core/files/recording.hpp"

namespace lookout::csht {
class CshtEstimator;
}

namespace lookout::tools {

/// Writes the vote matrices of the faithful estimator for the window that ends with the last scan at or
/// before `utime`: votes.csv (axis,velocity_mps,intercept_m,votes,threshold) and classes.csv
/// (axis,velocity_mps,intercept_m), axis north or east, intercepts at the middle of the window. For pictures.
/// @param sensor what the estimator is told.
/// @throws core::InputError where there is no scan with a pose by then.
void write_vote_matrices(const core::Recording& recording, const core::SonarParams& sensor,
                         std::int64_t utime, const std::string& directory);

/// The same of an estimator that keeps snapshots, for its last window.
void write_vote_matrices(const csht::CshtEstimator& estimator, const std::string& directory);

}  // namespace lookout::tools
