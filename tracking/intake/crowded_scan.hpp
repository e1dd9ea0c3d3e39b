#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/sonar_image.hpp"
#include "core/sonar_scan.hpp"

/// Scans that hold more returns than can be tracked in the time between two, and beams that hold several.
namespace lookout::tracking {

/// Returns of a scan that are tracked at most, for a sensor that pings every `period` [s]: 512, and fewer
/// where so many scans are remembered that memory asks for it.
std::size_t most_returns(double period);

/// Leaves out what is beyond `most` returns: beam by beam in turns the strongest is kept, of equal ones the
/// nearest; in the last turn some beams, spread over the fan, are left empty. The others stay in their order.
/// @return how many were left out.
std::int64_t thin_out(core::SonarScan& scan, std::size_t most);
std::int64_t thin_out(core::SonarImage& image, std::size_t most);  ///< None: images have no returns.

/// How many returns have a nearer one in their beam. @param heard room for a mark a beam, kept between calls.
std::int64_t returns_behind(const core::SonarScan& scan, std::vector<char>& heard);
std::int64_t returns_behind(const core::SonarImage& image, std::vector<char>& heard);  ///< None.

}  // namespace lookout::tracking
