#pragma once

#include <cstddef>
#include <string_view>

#include "core/sonar_image.hpp"
#include "core/sonar_scan.hpp"

/// What a ping heard, as bytes: how much room it takes, and whether it is that of the ping before.
namespace lookout::tracking {

/// The returns of a scan; valid while it lives.
std::string_view content_of(const core::SonarScan& scan);
std::string_view content_of(const core::SonarImage& image);  ///< The intensities of an image, likewise.

/// A hash of content; 0 for too little to tell a frozen sensor by: fewer bytes than three returns.
std::size_t hash_of(std::string_view content);

}  // namespace lookout::tracking
