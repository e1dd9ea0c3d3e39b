#include "tracking/node/local_estimate_sender.hpp"

#include <algorithm>
#include <tuple>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;  // [us]

}  // namespace

LocalEstimateSender::LocalEstimateSender(const LocalEstimateSenderParams& params, int message_bytes)
    : params_(params), message_bytes_(message_bytes) {
  core::require_positive("bytes_per_second", params.bytes_per_second);
  core::require_not_negative("burst_bytes", params.burst_bytes);
  core::require_positive("message_bytes", message_bytes);
  params_.burst_bytes = std::max(params.burst_bytes, static_cast<double>(message_bytes));
  tokens_ = params_.burst_bytes;
}

void LocalEstimateSender::fill_bucket(std::int64_t utime) {
  const double elapsed = std::max(0.0, core::seconds(utime - filled_utime_));
  tokens_ = std::min(params_.burst_bytes, tokens_ + elapsed * params_.bytes_per_second);
  filled_utime_ = utime;
}

void LocalEstimateSender::sort_by_wait(std::span<const core::Track> tracks) {
  waiting_.clear();
  std::map<std::int64_t, std::int64_t> alive;
  for (const core::Track& track : tracks) {
    const auto sent = sent_utime_.find(track.id);
    if (sent != sent_utime_.end()) alive.insert(*sent);
    if (track.status == core::TrackStatus::confirmed) waiting_.push_back(&track);
  }
  sent_utime_ = std::move(alive);
  const auto key = [&](const core::Track* track) {
    const auto sent = sent_utime_.find(track->id);
    const bool was_sent = sent != sent_utime_.end();
    return std::tuple(was_sent, was_sent ? sent->second : track->first_utime, track->id);
  };
  std::sort(waiting_.begin(), waiting_.end(), [&](const auto* a, const auto* b) { return key(a) < key(b); });
}

std::span<const core::LocalEstimate> LocalEstimateSender::select(const Scan& scan,
                                                                 std::span<const core::Track> tracks) {
  fill_bucket(scan.utime);
  sort_by_wait(tracks);
  selected_.clear();
  for (const core::Track* track : waiting_) {
    if (tokens_ < message_bytes_) break;
    send(scan, *track);
  }
  return selected_;
}

void LocalEstimateSender::send(const Scan& scan, const core::Track& track) {
  selected_.push_back(
      {scan.utime, scan.sequence, params_.node_id, scan.p_earth_sonar, track.id, track.state, std::nullopt});
  if (params_.with_covariance) selected_.back().covariance = track.covariance;
  const auto before = sent_utime_.find(track.id);
  if (before != sent_utime_.end())
    longest_wait_ = std::max(longest_wait_, core::seconds(scan.utime - before->second));
  sent_utime_[track.id] = scan.utime;
  tokens_ -= message_bytes_;
  ++messages_sent_;
  newest_second_.push_back(scan.utime);
  while (newest_second_.front() <= scan.utime - kSecond) newest_second_.pop_front();
  most_bytes_in_a_second_ =
      std::max(most_bytes_in_a_second_, static_cast<std::int64_t>(newest_second_.size()) * message_bytes_);
}

}  // namespace lookout::tracking
