#include "lcmtypes/inbox.hpp"

#include <stdexcept>

namespace lookout::lcmtypes {
namespace {

/// Sources of one channel that are told apart; more of them are damaged messages.
constexpr std::size_t kMaxSources = 64;

}  // namespace

std::string text_of(const Refusal& refusal) {
  return std::string(refusal.channel)
      .append(": ")
      .append(std::to_string(refusal.count))
      .append(" messages refused: ")
      .append(refusal.reason);
}

void Inbox::Entry::count_gap(std::int32_t source, std::int64_t sequence) {
  if (gaps.size() < kMaxSources || gaps.contains(source)) gaps[source].add(sequence);
}

void Inbox::Entry::note_handler_error() noexcept {
  ++counts.handler_errors;
  try {
    ++refusals["its handler failed"];
  } catch (...) {
    // Out of memory: the count still tells.
  }
}

void Inbox::add(const std::string& channel,
                std::function<std::string_view(const void*, std::size_t, Entry&)> take) {
  Entry& entry = entries_[channel];
  if (entry.take) throw std::invalid_argument("channel " + channel + " has a handler already");
  entry.take = std::move(take);
}

void Inbox::overhear(const std::string& channel, std::function<void(std::span<const std::uint8_t>)> handler) {
  entries_[channel].overhear = std::move(handler);
}

void Inbox::on_bytes(const std::string& channel, std::function<void(std::span<const std::uint8_t>)> handler) {
  add(channel, [handler = std::move(handler)](const void* data, std::size_t size, Entry&) {
    handler({static_cast<const std::uint8_t*>(data), size});
    return std::string_view();
  });
}

void Inbox::take(const std::string& channel, const void* data, std::size_t size) noexcept {
  const auto found = entries_.find(channel);
  if (found == entries_.end()) return;
  Entry& entry = found->second;
  ++entry.counts.received;
  try {
    const std::string_view refusal = hand_over(entry, data, size);
    if (refusal.empty()) return;
    ++entry.refusals[refusal];
    note(channel, refusal);
  } catch (const std::exception& error) {
    entry.note_handler_error();
    note(channel, error.what());
  } catch (...) {
    entry.note_handler_error();
    note(channel, "unknown exception");
  }
}

std::string_view Inbox::hand_over(Entry& entry, const void* data, std::size_t size) {
  if (entry.overhear) entry.overhear({static_cast<const std::uint8_t*>(data), size});
  return entry.take ? entry.take(data, size, entry) : std::string_view();
}

void Inbox::note(const std::string& channel, std::string_view what) noexcept {
  try {
    last_error_ = channel + ": " + std::string(what);
  } catch (...) {
    // Out of memory: the counts still tell.
  }
}

ChannelCounts Inbox::counts(const std::string& channel) const {
  const auto found = entries_.find(channel);
  if (found == entries_.end()) return {};
  ChannelCounts counts = found->second.counts;
  for (const auto& [source, gaps] : found->second.gaps) {
    counts.lost += gaps.lost();
    counts.restarts += gaps.restarts();
  }
  return counts;
}

std::int64_t Inbox::bad_messages() const {
  std::int64_t sum = 0;
  for (const auto& [channel, entry] : entries_)
    sum += entry.counts.undecodable + entry.counts.refused + entry.counts.handler_errors;
  return sum;
}

std::vector<Refusal> Inbox::refusals() const {
  std::vector<Refusal> all;
  for (const auto& [channel, entry] : entries_) {
    for (const auto& [reason, count] : entry.refusals) all.push_back({channel, reason, count});
  }
  return all;
}

}  // namespace lookout::lcmtypes
