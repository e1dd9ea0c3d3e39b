#include "sonar_sim/random_streams.hpp"

namespace lookout::sonar_sim {

core::Random open_stream(const StreamKey& key, StreamPurpose purpose) {
  // The lowest bits are the run's; then the platform and, in one bit, whether echoes or navigation are drawn;
  // above them the sonar and all later purposes.
  const auto number = static_cast<std::uint64_t>(purpose);
  const std::uint64_t low_purpose = number <= 1 ? number : 0, high_purpose = number <= 1 ? 0 : number;
  const std::uint64_t low = static_cast<std::uint64_t>(key.platform) * 2 + low_purpose;
  const std::uint64_t high = high_purpose << 8 | static_cast<std::uint64_t>(key.sonar);
  return {key.seed, core::RandomStream::simulator, high << 52 | low << 40 | key.run};
}

}  // namespace lookout::sonar_sim
