// LOCAL_ESTIMATE -> fusion -> GLOBAL_TRACKS
#include "fusion/fusion_node.hpp"

#include <array>
#include <cmath>
#include <sstream>

#include "core/frames.hpp"

namespace lookout::fusion {

FusionNode::FusionNode(lcmtypes::Bus& bus, const FusionNodeParams& params)
    : bus_(bus),
      channels_(params.channel_prefix),
      status_(bus, channels_.status(), "lookout fuse", 0),
      fusion_(params.fusion) {
  bus_.subscribe<local_estimate_t>(lcmtypes::Channels::kLocalEstimate,
                                   [this](const core::LocalEstimate& estimate) { take(estimate); });
}

void FusionNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { every_second(); }).run();
  bus_.drain();
  publish_pending();
  every_second();
}

void FusionNode::take(const core::LocalEstimate& estimate) {
  heard_since_second_ = true;
  watch_sender(estimate);
  const auto before = fusion_.newest();
  const std::int64_t restarts = fusion_.restarts();
  // A newer estimate says that the time before is complete; it is fused without the newcomer.
  if (pending_ && estimate.utime + fusion_.clock().offset(estimate.node_id) > *pending_) publish_pending();
  if (fusion_.add(estimate) != Intake::accepted) return;
  if (fusion_.newest() != before || fusion_.restarts() != restarts) pending_ = fusion_.newest();
}

/// One node is at one place: a position that leaps to and fro is that of two vehicles with one id.
void FusionNode::watch_sender(const core::LocalEstimate& estimate) {
  if (newest_of_.size() >= kMostWatched && !newest_of_.contains(estimate.node_id)) return;
  const auto [known, is_new] = newest_of_.try_emplace(estimate.node_id, estimate);
  if (is_new) return;
  const double seconds = std::abs(core::seconds(estimate.utime - known->second.utime));
  const double way = (estimate.p_earth_node - known->second.p_earth_node).norm();
  known->second = estimate;
  if (way <= kLeap + kFastest * seconds) return;
  ++leaps_;
  leaping_node_ = estimate.node_id;
}

/// What was refused, by reason, and who seems to be two.
std::string FusionNode::troubles() const {
  constexpr std::array<const char*, kNumIntakes> kNames{
      "accepted",           "implausible", "repeated", "out of order", "off the common clock",
      "without covariance", "too many"};
  std::ostringstream text;
  for (std::size_t outcome = 1; outcome < kNumIntakes; ++outcome) {
    const std::int64_t count = fusion_.count(static_cast<Intake>(outcome));
    if (count > 0) text << (text.tellp() > 0 ? ", " : "refused: ") << count << " " << kNames.at(outcome);
  }
  if (leaps_ > 1)
    text << (text.tellp() > 0 ? "; " : "") << "node " << leaping_node_
         << " leaps to and fro: two vehicles with its id?";
  const std::string& damaged = bus_.inbox().last_error();
  if (!damaged.empty()) text << (text.tellp() > 0 ? "; last: " : "") << damaged;
  return text.str();
}

void FusionNode::publish_pending() {
  if (!pending_) return;
  const auto list = lcmtypes::to_wire({*pending_, published_, 0}, fusion_.update(*pending_));
  pending_.reset();
  bus_.publish(lcmtypes::Channels::kGlobalTracks, list.message);
  ++published_;
  left_out_ += static_cast<std::int64_t>(list.left_out);
}

std::int64_t FusionNode::refused() const {
  std::int64_t sum = bus_.inbox().bad_messages();
  for (std::size_t outcome = 0; outcome < kNumIntakes; ++outcome) {
    if (static_cast<Intake>(outcome) != Intake::accepted) sum += fusion_.count(static_cast<Intake>(outcome));
  }
  return sum;
}

void FusionNode::every_second() {
  if (!heard_since_second_) publish_pending();
  heard_since_second_ = false;
  status_.publish({fusion_.newest().value_or(0), fusion_.count(Intake::accepted), refused(), left_out_},
                  troubles());
}

}  // namespace lookout::fusion
