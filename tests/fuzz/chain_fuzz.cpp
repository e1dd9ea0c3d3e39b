// The messages of a log through the inbox into a tracker: the first byte names it. Tracks are finite, their
// times those of scans.
#include <array>
#include <cmath>

#include "lcmtypes/channels.hpp"
#include "lcmtypes/inbox.hpp"
#include "lcmtypes/log_reader.hpp"
#include "tests/fuzz/fuzz_support.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tests {
namespace {

constexpr std::array kTrackers{"gnn", "csht", "joint"};

void check(const tracking::PingResult& result) {
  for (const core::Track& track : result.tracks)
    require(track.state.allFinite() && track.covariance.allFinite() && track.existence >= 0.0 &&
            track.existence <= 1.0);
}

void track(const std::string& log, const char* tracker) {
  tracking::ChainParams params;
  params.tracker.name = tracker;
  tracking::TrackingChain chain(params, check);
  lcmtypes::Inbox inbox;
  inbox.on<vehicle_state_t>("VEHICLE_STATE", [&](const core::VehicleState& state) { chain.add(state); });
  inbox.on<sonar_scan_t>("SONAR_SCAN", [&](core::SonarScan scan) { chain.add(std::move(scan)); });
  lcmtypes::LogReader reader(log);
  while (const auto message = reader.next())
    inbox.take(message->channel, message->bytes.data(), message->bytes.size());
  chain.finish();
  for (const char* channel : {"VEHICLE_STATE", "SONAR_SCAN"})
    require(inbox.counts(channel).handler_errors == 0);
  const tracking::IntakeCounts& counts = chain.counts();
  require(counts.received == counts.accepted + counts.rejected());
}

}  // namespace
}  // namespace lookout::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout::tests;
  if (size == 0) return 0;
  const std::string path = write_scratch("log", as_text(data + 1, size - 1));
  read_or_refuse([&] { track(path, kTrackers[*data % kTrackers.size()]); });
  return 0;
}
