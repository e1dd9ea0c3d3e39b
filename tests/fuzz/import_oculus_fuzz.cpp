// The packets of an Oculus sonar: a ping has as many intensities as its beams and bins say, and its clock
// never falls.
#include "tests/fuzz/fuzz_support.hpp"
#include "tools/import/oculus_packets.hpp"
#include "tools/import/wrapped_clock.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  tools::OculusPackets packets({data, size}, "dive.oculus");
  tools::WrappedClock clock;
  double last = 0.0;
  while (const auto ping = packets.next()) {
    const core::SonarImage& image = ping->image;
    tests::require(image.intensity.size() ==
                   image.bearings.size() * static_cast<std::size_t>(image.num_bins));
    const double time = clock.add(ping->number, ping->start, ping->wrap);
    tests::require(time >= last);
    last = time;
  }
  return 0;
}
