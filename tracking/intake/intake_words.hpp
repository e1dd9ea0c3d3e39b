#pragma once

#include <cstdint>
#include <string>

#include "core/sonar_image.hpp"
#include "core/sonar_scan.hpp"

/// The parts of the lines that the intake says to a person.
namespace lookout::tracking {

/// Whether the n-th event of a kind is worth a line: the first, second, fourth, ..., so that a stream of bad
/// input does not become a stream of lines. @param n >= 1.
bool worth_a_line(std::int64_t n);

std::string at_time(std::int64_t utime);  ///< " at 1.5 s"
std::string so_far(std::int64_t count);   ///< " (3 so far)"

std::string described(const core::SonarScan& scan);    ///< "scan of sensor 2 at 1.5 s"
std::string described(const core::SonarImage& image);  ///< "image at 1.5 s"

}  // namespace lookout::tracking
