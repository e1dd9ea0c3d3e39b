#pragma once

#include <string>
#include <vector>

namespace lookout::tools {

/// Writes what an LCM log holds into `directory` as it stands, tracked by nobody anew: the files of a
/// recording, tracks.csv with `covariance_nn_m2,covariance_ne_m2,covariance_ee_m2`, and ospa.csv where the
/// log has OSPA. @return a line for each kind of message that is not in them.
/// @throws core::InputError where the file is no readable log, or holds nothing of ours.
std::vector<std::string> write_log_tables(const std::string& log, const std::string& channel_prefix,
                                          const std::string& directory);

}  // namespace lookout::tools
