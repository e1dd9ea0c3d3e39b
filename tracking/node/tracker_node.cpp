// VEHICLE_STATE, SONAR_SCAN (SONAR_IMAGE) -> queue -> chain -> MOTION_ELEMENTS, TRACKS, SENSOR_ESTIMATE,
// LOCAL_ESTIMATE
#include "tracking/node/tracker_node.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "core/input_error.hpp"
#include "lcmtypes/state_file.hpp"

namespace lookout::tracking {
namespace {

constexpr int kSecondsBetweenStates = 2;
constexpr std::chrono::milliseconds kWorkAtStop{100};  // After the signal.

/// How a ping comes over the wire.
template <class Ping>
struct WireOf;
template <>
struct WireOf<core::SonarScan> {
  using Message = sonar_scan_t;
  static std::string channel(const lcmtypes::Channels& channels) { return channels.sonar_scan(); }
};
template <>
struct WireOf<core::SonarImage> {
  using Message = sonar_image_t;
  static std::string channel(const lcmtypes::Channels& channels) { return channels.sonar_image(); }
};

std::size_t max_waiting(const lcmtypes::Bus& bus, const TrackerNodeParams& params) {
  const auto unlimited = std::numeric_limits<std::size_t>::max();
  return params.max_waiting.value_or(bus.is_live() ? TrackerNodeParams::kMaxWaiting : unlimited);
}

}  // namespace

template <class Chain>
ChainNode<Chain>::ChainNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, const MakeChain& make_chain,
                            Report report)
    : bus_(bus),
      params_(params),
      max_waiting_(max_waiting(bus, params)),
      node_(bus, params, std::move(report)),
      chain_(make_chain([this](const PingResult& result) { publish(result); },
                        [this](const std::string& line) { node_.note(line); })) {
  load_state();
  listen();
}

template <class Chain>
void ChainNode<Chain>::listen() {
  bus_.subscribe<vehicle_state_t>(node_.channels().vehicle_state(),
                                  [this](const core::VehicleState& state) { take(state); });
  bus_.subscribe<typename WireOf<Ping>::Message>(WireOf<Ping>::channel(node_.channels()),
                                                 [this](Ping ping) { take(std::move(ping)); });
}

/// Handles a message at once where no ping may be shed; else it waits in the queue.
template <class Chain>
void ChainNode<Chain>::take(std::variant<core::VehicleState, Ping> data) {
  const bool is_ping = data.index() == 1;
  if (is_ping) watch_stamps(std::get<Ping>(data).utime);
  Arrived arrived{bus_.arrival(), std::move(data)};
  if (max_waiting_ == std::numeric_limits<std::size_t>::max()) return handle(std::move(arrived));
  queue_.push_back(std::move(arrived));
  if (is_ping && ++pings_waiting_ > max_waiting_) shed_oldest();
}

/// The health says what is wrong; a line says it once.
template <class Chain>
void ChainNode<Chain>::watch_stamps(std::int64_t utime) {
  using std::chrono::duration_cast, std::chrono::microseconds;
  stamps_.add(utime, duration_cast<microseconds>(bus_.arrival().time_since_epoch()).count());
  if (stamps_.doubted() == 1)
    node_.note("stamps go " + std::to_string(stamps_.slower().value_or(0)) +
               " times slower than pings come: utime counts microseconds");
}

template <class Chain>
void ChainNode<Chain>::shed_oldest() {
  const auto is_ping = [](const Arrived& arrived) { return arrived.data.index() == 1; };
  const auto oldest = std::find_if(queue_.begin(), queue_.end(), is_ping);
  chain_->shed(std::get<Ping>(oldest->data));
  queue_.erase(oldest);
  --pings_waiting_;
  const std::int64_t shed = chain_->counts().shed;
  if ((shed & (shed - 1)) == 0)  // The first, second, fourth, ...
    node_.note("overloaded: more than " + std::to_string(max_waiting_) + " wait, the oldest is shed (" +
               std::to_string(shed) + " so far)");
}

/// Handles what waits, up to one ping and what comes before it. Returns whether more waits.
template <class Chain>
bool ChainNode<Chain>::work() {
  while (!queue_.empty()) {
    Arrived arrived = std::move(queue_.front());
    queue_.pop_front();
    const bool is_ping = arrived.data.index() == 1;
    if (is_ping) --pings_waiting_;
    handle(std::move(arrived));
    if (is_ping) break;
  }
  return !queue_.empty();
}

template <class Chain>
void ChainNode<Chain>::handle(Arrived arrived) {
  node_.note_handling(arrived.arrival);
  std::visit([this](auto data) { chain_->add(std::move(data)); }, std::move(arrived.data));
}

template <class Chain>
void ChainNode<Chain>::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop loop(bus_, limits, [this, &limits] { every_second(limits); });
  loop.work_by([this] { return work(); });
  if constexpr (requires { chain_->stop_when([] { return false; }); })
    chain_->stop_when([this, &limits] { return must_end(limits); });
  loop.run();
  bus_.drain();
  // A node that is told to stop works off what has arrived, but not for long: what waits beyond is shed.
  while (work())
    if (must_end(limits))
      while (pings_waiting_ > 0) shed_oldest();
  chain_->finish();
  publish_status();
  save_state();
  if constexpr (requires { chain_->stop_when({}); }) chain_->stop_when([] { return false; });
}

/// Whether a stop signal came so long ago that no more work is begun.
template <class Chain>
bool ChainNode<Chain>::must_end(const lcmtypes::LoopLimits& limits) {
  if (!limits.stopped()) return false;
  const auto now = PingNode::Clock::now();
  if (!stopped_at_) stopped_at_ = now;
  return now - *stopped_at_ > kWorkAtStop;
}

/// An identity is kept before it is told: after a restart its track would else have another one.
template <class Chain>
void ChainNode<Chain>::publish(const PingResult& result) {
  const auto is_new = [this](const core::Track& track) {
    return track.status != core::TrackStatus::tentative &&
           std::find(kept_.begin(), kept_.end(), track.id) == kept_.end();
  };
  if (!params_.state_file.empty() && std::any_of(result.tracks.begin(), result.tracks.end(), is_new))
    save_state();
  node_.publish(result);
}

template <class Chain>
void ChainNode<Chain>::every_second(const lcmtypes::LoopLimits& limits) {
  publish_status();
  limits.tell_state(node_.health().text());
  if (++seconds_ < kSecondsBetweenStates) return;
  seconds_ = 0;
  save_state();
}

template <class Chain>
void ChainNode<Chain>::publish_status() {
  const IntakeCounts& counts = chain_->counts();
  HealthSample sample;
  sample.pings = counts.received;
  sample.states = counts.states;
  sample.returns = counts.returns;
  sample.dropped_returns = counts.dropped_returns;
  sample.crowded = counts.crowded;
  sample.shed_returns = counts.shed_returns;
  sample.repeated = counts.repeated;
  sample.contradicting = counts.contradicting;
  sample.off_pace = counts.off_pace + stamps_.doubted();
  sample.wide_headings = counts.wide_headings;
  sample.restarts = counts.backwards + counts.foreign;
  node_.publish_status(figures(), sample);
}

template <class Chain>
lcmtypes::NodeFigures ChainNode<Chain>::figures() const {
  const IntakeCounts& counts = chain_->counts();
  return {chain_->newest_utime(), counts.accepted,
          counts.rejected() + counts.bad_states + bus_.inbox().bad_messages(), counts.lost, counts.shed};
}

template <class Chain>
void ChainNode<Chain>::load_state() {
  if (params_.state_file.empty()) return;
  if constexpr (requires { chain_->remember(); }) {
    chain_->remember();
    chain_->stop_when(params_.stopped);
    const lcmtypes::LoadedState state = lcmtypes::load_state(params_.state_file);
    if (!state.refusal.empty())
      return node_.note(params_.state_file + ": " + state.refusal + "; starting without what was known");
    if (!state.memory) return;
    const std::size_t found = chain_->restore(*state.memory);
    if (params_.stopped()) return;
    node_.note("goes on where " + params_.state_file +
               " ended: " + std::to_string(state.memory->scans.size()) + " scans tracked again, " +
               std::to_string(found) + " tracks found again");
  } else {
    throw core::InputError("--state: is kept of scans alone, expected none with images");
  }
}

template <class Chain>
void ChainNode<Chain>::save_state() {
  if constexpr (requires { chain_->memory(); }) {
    if (params_.state_file.empty() || chain_->counts().accepted == 0) return;
    const core::TrackingMemory memory = chain_->memory();
    kept_.clear();
    // Nobody looks for a tentative one after a restart: it is kept when it is confirmed.
    for (const auto& track : memory.tracks)
      if (track.status != core::TrackStatus::tentative) kept_.push_back(track.id);
    try {
      lcmtypes::save_state(params_.state_file, memory);
    } catch (const std::exception& error) {
      node_.note(error.what());
    }
  }
}

template class ChainNode<TrackingChain>;
template class ChainNode<ImageChain>;
template class ChainNode<DetectionChain>;

}  // namespace lookout::tracking
