// LOCAL_ESTIMATE -> fusion -> GLOBAL_TRACKS
#include "fusion/fusion_node.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "core/frames.hpp"

namespace lookout::fusion {
namespace {

constexpr std::chrono::milliseconds kLastWork{300};  // After a stop signal.
constexpr double kPercent = 100.0;
constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

/// Those that say something.
std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) {
    if (line.empty()) continue;
    if (!text.empty()) text += "; ";
    text += line;
  }
  return text;
}

}  // namespace

FusionNode::FusionNode(lcmtypes::Bus& bus, const FusionNodeParams& params)
    : bus_(bus),
      channels_(params.channel_prefix),
      status_(bus, channels_.status(), "lookout fuse", 0),
      fusion_(params.fusion),
      max_waiting_(params.max_waiting.value_or(bus.is_live() ? FusionNodeParams::kMostWaiting : kUnlimited)) {
  bus_.subscribe<local_estimate_t>(lcmtypes::Channels::kLocalEstimate,
                                   [this](const core::LocalEstimate& estimate) { take(estimate); });
}

void FusionNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop loop(bus_, limits, [this] { every_second(); });
  loop.work_by([this] { return work(); });
  loop.run();
  bus_.drain();
  finish(limits);
  publish_pending();
  every_second();
}

/// What waits is fused, but who is told to stop does not work on for long.
void FusionNode::finish(const lcmtypes::LoopLimits& limits) {
  const auto deadline = lcmtypes::NodeLoop::Clock::now() + kLastWork;
  while (work())
    if (limits.stopped() && lcmtypes::NodeLoop::Clock::now() > deadline) break;
  shed_ += static_cast<std::int64_t>(waiting_.size());
  waiting_.clear();
}

void FusionNode::take(const core::LocalEstimate& estimate) {
  heard_since_second_ = true;
  watch_sender(estimate);
  if (max_waiting_ == kUnlimited) return fuse(estimate);  // Where nothing may be shed nothing needs to wait.
  waiting_.push_back(estimate);
  ++waiting_of_[estimate.node_id];
  if (waiting_.size() > max_waiting_) shed_one();
}

/// The oldest of the node that has most: a flood costs its sender alone.
void FusionNode::shed_one() {
  const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto most = std::max_element(waiting_of_.begin(), waiting_of_.end(), fewer);
  const auto is_its = [&](const core::LocalEstimate& one) { return one.node_id == most->first; };
  waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), is_its));
  if (--most->second == 0) waiting_of_.erase(most);
  ++shed_;
}

/// Fuses one estimate. Returns whether more wait.
bool FusionNode::work() {
  if (waiting_.empty()) return false;
  const core::LocalEstimate estimate = std::move(waiting_.front());
  waiting_.pop_front();
  if (const auto its = waiting_of_.find(estimate.node_id); --its->second == 0) waiting_of_.erase(its);
  fuse(estimate);
  return !waiting_.empty();
}

void FusionNode::fuse(const core::LocalEstimate& estimate) {
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

/// What was refused, who seems to be two, whose tracks prove false, and what was lost.
std::string FusionNode::troubles() const {
  std::vector<std::string> lines{refusals()};
  if (leaps_ > 1)
    lines.push_back("node " + std::to_string(leaping_node_) + " leaps to and fro: two vehicles with its id?");
  for (const auto& [node_id, newest] : newest_of_) {
    const double credit = fusion_.global_tracks().credit_of(node_id);
    if (credit < fusion_.params().global.credit.least)
      lines.push_back("node " + std::to_string(node_id) + " has credit " +
                      std::to_string(std::lround(kPercent * credit)) + " %: its tracks prove false");
  }
  if (shed_ > 0) lines.push_back("overloaded: shed " + std::to_string(shed_));
  if (const std::int64_t dropped = bus_.dropped_datagrams(); dropped > 0)
    lines.push_back(std::to_string(dropped) + " datagrams found no room");
  if (left_out_ > 0) lines.push_back(std::to_string(left_out_) + " tracks found no room in a message");
  if (const std::string& damaged = bus_.inbox().last_error(); !damaged.empty())
    lines.push_back("last: " + damaged);
  return joined(lines);
}

/// What was refused, by reason.
std::string FusionNode::refusals() const {
  constexpr std::array<const char*, kNumIntakes> kNames{
      "accepted",           "implausible", "repeated", "out of order", "off the common clock",
      "without covariance", "too many"};
  std::ostringstream text;
  for (std::size_t outcome = 1; outcome < kNumIntakes; ++outcome) {
    const std::int64_t count = fusion_.count(static_cast<Intake>(outcome));
    if (count > 0) text << (text.tellp() > 0 ? ", " : "refused: ") << count << " " << kNames.at(outcome);
  }
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
  status_.publish({fusion_.newest().value_or(0), fusion_.count(Intake::accepted), refused(),
                   bus_.dropped_datagrams(), shed_},
                  troubles());
}

}  // namespace lookout::fusion
