// GROUND_TRUTH, TRACKS -> pairs of one time -> scorer -> OSPA
#include "tracking/metrics/score_node.hpp"

#include <algorithm>
#include <cstdlib>

namespace lookout::tracking {
namespace {

/// Times that differ by no more are one time [us].
constexpr std::int64_t kSameTime = 1;
/// Truths and track lists that may wait for their other half; older ones are given up.
constexpr std::size_t kMaxWaiting = 1000;

bool same_time(std::int64_t a, std::int64_t b) {
  return std::abs(a - b) <= kSameTime;
}

/// Takes the oldest entry for which `matches` out of `waiting`.
template <class Entry, class Matches>
std::optional<Entry> take_match(std::deque<Entry>& waiting, const Matches& matches) {
  const auto found = std::find_if(waiting.begin(), waiting.end(), matches);
  if (found == waiting.end()) return std::nullopt;
  Entry entry = std::move(*found);
  waiting.erase(found);
  return entry;
}

/// @return how many are given up for it.
template <class Entry>
std::int64_t keep(std::deque<Entry>& waiting, Entry entry) {
  waiting.push_back(std::move(entry));
  if (waiting.size() <= kMaxWaiting) return 0;
  waiting.pop_front();
  return 1;
}

}  // namespace

ScoreNode::ScoreNode(lcmtypes::Bus& bus, const ScoreNodeParams& params, Scorer scorer)
    : bus_(bus),
      params_(params),
      channels_(params.channel_prefix),
      tracks_channel_(params.tracks_channel.empty() ? channels_.tracks() : params.tracks_channel),
      status_(bus, channels_.status(), "lookout score", 0),
      scorer_(std::move(scorer)) {
  bus_.subscribe<ground_truth_t>(channels_.ground_truth(),
                                 [this](core::GroundTruth truth) { take(std::move(truth)); });
  bus_.subscribe<track_list_t>(tracks_channel_,
                               [this](lcmtypes::KeyedTracks tracks) { take(std::move(tracks)); });
}

void ScoreNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { publish_status(); }).run();
  bus_.drain();
  publish_status();
}

void ScoreNode::take(core::GroundTruth truth) {
  ++truths_;
  const auto tracks = take_match(waiting_tracks_, [&truth](const lcmtypes::KeyedTracks& waiting) {
    return same_time(waiting.key.utime, truth.utime);
  });
  if (tracks) return score(truth, *tracks);
  given_up_ += keep(waiting_truth_, std::move(truth));
}

void ScoreNode::take(lcmtypes::KeyedTracks tracks) {
  ++tracks_;
  const auto truth = take_match(waiting_truth_, [&tracks](const core::GroundTruth& waiting) {
    return same_time(waiting.utime, tracks.key.utime);
  });
  if (truth) return score(*truth, tracks);
  given_up_ += keep(waiting_tracks_, std::move(tracks));
}

void ScoreNode::score(const core::GroundTruth& truth, const lcmtypes::KeyedTracks& tracks) {
  const auto begin = lcmtypes::NodeLoop::Clock::now();
  const OspaResult& ospa = scorer_.add(truth, tracks.tracks).position;
  ospa_t wire{};
  wire.utime = tracks.key.utime;
  wire.cutoff = params_.ospa.cutoff;
  wire.order = params_.ospa.order;
  wire.total = ospa.total;
  wire.localization = ospa.localization;
  wire.cardinality = ospa.cardinality;
  wire.num_truth = static_cast<std::int16_t>(ospa.num_truth);
  wire.num_tracks = static_cast<std::int16_t>(ospa.num_tracks);
  bus_.publish(channels_.ospa(), wire);
  newest_utime_ = tracks.key.utime;
  status_.add_latency(
      std::chrono::duration<double, std::milli>(lcmtypes::NodeLoop::Clock::now() - begin).count());
}

void ScoreNode::publish_status() {
  const auto lost = bus_.inbox().counts(tracks_channel_).lost;
  std::string trouble = bus_.inbox().last_error();
  if (trouble.empty() && given_up_ > 0)
    trouble = std::to_string(given_up_) + " truths and track lists given up: nothing came at their times";
  status_.publish({newest_utime_, scorer_.num_scans(), bus_.inbox().bad_messages(), lost}, trouble);
}

}  // namespace lookout::tracking
