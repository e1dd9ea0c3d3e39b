#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "core/local_estimate.hpp"
#include "core/track.hpp"

namespace lookout::tracking {

/// Who sends, and how much the link carries.
struct LocalEstimateSenderParams {
  std::int32_t node_id = 1;  ///< Of the vehicle, unique among those that share the link.
  double bytes_per_second =
      256.0;  ///< Of the link, payload and LCM header together, > 0: an acoustic modem's.
  /// What an idle link saves up, >= 0, one message at least: half a second's worth. In any t seconds at most
  /// burst + t * rate goes out. Own choice.
  double burst_bytes = 128.0;
  bool with_covariance = false;  ///< Send covariances too, for the methods that need them.
};

/// Chooses which tracks of a node go out over its thin link: a token bucket, and of the confirmed tracks the
/// one that has waited longest first. Runs on data time.
class LocalEstimateSender {
 public:
  /// @param message_bytes that one estimate takes on the link, > 0: lcmtypes::local_estimate_bytes.
  /// @throws std::invalid_argument on a parameter out of range.
  LocalEstimateSender(const LocalEstimateSenderParams& params, int message_bytes);

  /// The scan that the tracks belong to, and from where it was taken.
  struct Scan {
    std::int64_t utime = 0;               ///< Scenario time [us].
    std::int64_t sequence = 0;            ///< Of the scan.
    Eigen::Vector2d p_earth_sonar{0, 0};  ///< North, east of the sonar [m].
  };

  /// What to send after this scan; valid until the next call. Tentative and coasting tracks stay at home.
  std::span<const core::LocalEstimate> select(const Scan& scan, std::span<const core::Track> tracks);

  std::int64_t messages_sent() const { return messages_sent_; }  ///< Since the start.
  /// Since the start, LCM header included.
  std::int64_t bytes_sent() const { return messages_sent_ * message_bytes_; }
  std::int64_t most_bytes_in_a_second() const { return most_bytes_in_a_second_; }  ///< Over any second.
  double longest_wait() const { return longest_wait_; }  ///< Of a track between two of its messages [s].

 private:
  void fill_bucket(std::int64_t utime);
  void sort_by_wait(std::span<const core::Track> tracks);
  void send(const Scan& scan, const core::Track& track);

  LocalEstimateSenderParams params_;
  int message_bytes_;
  double tokens_ = 0.0;
  std::int64_t filled_utime_ = 0;
  std::map<std::int64_t, std::int64_t> sent_utime_;  ///< Of each track that is alive.
  std::vector<const core::Track*> waiting_;
  std::vector<core::LocalEstimate> selected_;

  std::int64_t messages_sent_ = 0;
  std::deque<std::int64_t> newest_second_;  ///< Times of the messages of the last second.
  std::int64_t most_bytes_in_a_second_ = 0;
  double longest_wait_ = 0.0;
};

}  // namespace lookout::tracking
