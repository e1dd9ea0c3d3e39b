// A tracker's memory: the body of a state file, whose head and checksum the target makes; or, with a first
// byte of 0, a whole file. What is read can be gone on from.
#include <boost/crc.hpp>

#include "lcmtypes/state_file.hpp"
#include "tests/fuzz/fuzz_support.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tests {
namespace {

void append(std::string& text, std::int64_t number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A state file with that body.
std::string framed(std::string_view body) {
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  std::string text = "lookout state 1\n";
  append(text, static_cast<std::int64_t>(body.size()));
  append(text, static_cast<std::int64_t>(crc.checksum()));
  return text.append(body);
}

void go_on(const core::TrackingMemory& memory) {
  tracking::ChainParams params;
  params.tracker.name = "gnn";
  tracking::TrackingChain chain(params, [](const tracking::PingResult&) {});
  chain.restore(memory);
  require(chain.memory().next_id >= memory.next_id);
}

}  // namespace
}  // namespace lookout::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout::tests;
  if (size == 0) return 0;
  const std::string_view rest = as_text(data + 1, size - 1);
  const auto loaded = lookout::lcmtypes::read_state(*data == 0 ? std::string(rest) : framed(rest));
  require(loaded.memory.has_value() == loaded.refusal.empty());
  if (loaded.memory) go_on(*loaded.memory);
  return 0;
}
