// An estimate in 32 bytes, of which the target makes the last, the check: what comes out is finite.
#include <algorithm>
#include <boost/crc.hpp>

#include "lcmtypes/compact_estimate.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  lcmtypes::CompactEstimate packet{};
  std::copy_n(data, std::min(size, packet.size() - 1), packet.begin());
  boost::crc_optimal<8, 0x07, 0xFF, 0, false, false> check;
  check.process_bytes(packet.data(), packet.size() - 1);
  packet.back() = check.checksum();
  constexpr std::int64_t kNow = 1'700'000'000'000'000;  // [us]
  const auto estimate = lcmtypes::unpack(packet, kNow);
  tests::require(estimate.has_value());
  tests::require(estimate->state.allFinite() && estimate->p_earth_node.allFinite());
  if (estimate->covariance) tests::require(estimate->covariance->allFinite());
  return 0;
}
