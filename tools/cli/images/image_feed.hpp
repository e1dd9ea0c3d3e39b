#pragma once

#include <cstddef>

#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"

namespace lookout::tools {

/// Takes the vehicle states and images of a recording to a chain in the order of their times, of one time the
/// state first, clock by clock. A fixed sensor's state stands at the origin at the time of each image.
/// @param chain with add(core::VehicleState), add(core::SonarImage) and start_new_clock().
/// @throws core::InputError naming an image that cannot be read.
template <class Chain>
void feed_images(Chain& chain, const core::Recording& recording, const core::ImageReader& images) {
  std::size_t state = 0, image = 0;
  for (std::size_t clock = 0; clock <= recording.new_clocks.size(); ++clock) {
    if (clock > 0) chain.start_new_clock();
    const std::size_t states =
        clock < recording.new_clocks.size() ? recording.new_clocks[clock].state : recording.vehicle.size();
    for (; image < images.size() && images.clock(image) <= static_cast<int>(clock); ++image) {
      while (!recording.is_fixed && state < states && recording.vehicle[state].utime <= images.utime(image))
        chain.add(recording.vehicle[state++]);
      if (recording.is_fixed) chain.add(core::VehicleState{images.utime(image), {}, {0.0, 0.0}});
      chain.add(images.read(image));
    }
    while (!recording.is_fixed && state < states) chain.add(recording.vehicle[state++]);
  }
}

}  // namespace lookout::tools
