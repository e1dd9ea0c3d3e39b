// One message of any type: the first byte names the type, whose fingerprint the target puts before the rest.
#include <array>
#include <vector>

#include <lookout/decisions_t.hpp>
#include <lookout/node_status_t.hpp>
#include "lcmtypes/convert_reports.hpp"
#include "lcmtypes/inbox.hpp"
#include "tests/fuzz/fuzz_support.hpp"

namespace lookout::tests {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The message: the type's fingerprint, big endian, then the body.
template <class Wire>
Bytes message(std::string_view body) {
  constexpr unsigned kByte = 8;
  Bytes bytes(sizeof(std::int64_t));
  auto hash = static_cast<std::uint64_t>(Wire::getHash());
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte, hash >>= kByte)
    *byte = static_cast<std::uint8_t>(hash);
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

/// What is decoded is all of the message and nothing else: it encodes to the same bytes.
template <class Wire>
void take(std::string_view body) {
  const Bytes bytes = message<Wire>(body);
  const auto wire = lcmtypes::decode<Wire>(bytes.data(), bytes.size());
  if (!wire) return;
  Bytes again(bytes.size());
  require(wire->encode(again.data(), 0, static_cast<int>(again.size())) == static_cast<int>(bytes.size()));
  require(again == bytes);
  const auto converted = lcmtypes::to_core(*wire);
  require(converted.value.has_value() == converted.refusal.empty());
}

void take_status(std::string_view body) {
  lcmtypes::read_node_status(message<node_status_t>(body));
}

void take_ospa(std::string_view body) {
  lcmtypes::read_ospa(message<ospa_t>(body));
}

void take_decisions(std::string_view body) {
  lcmtypes::read_decisions(message<decisions_t>(body));
}

constexpr std::array kTypes{take<vehicle_state_t>,
                            take<sonar_scan_t>,
                            take<sonar_image_t>,
                            take<ground_truth_t>,
                            take<motion_elements_t>,
                            take<track_list_t>,
                            take<sensor_estimate_t>,
                            take<local_estimate_t>,
                            take_status,
                            take_ospa,
                            take_decisions};

}  // namespace
}  // namespace lookout::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout::tests;
  if (size > 0) kTypes[*data % kTypes.size()](as_text(data + 1, size - 1));
  return 0;
}
