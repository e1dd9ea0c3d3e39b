#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace lookout::fusion {

/// Which time stamps belong to one clock.
struct FusionClockParams {
  double tolerance = 5.0;  ///< Time stamps this far from the newest are late or early messages of one clock;
                           ///< farther ones tell of another clock [s], > 0. Own choice.
  int consistent = 3;      ///< Messages in a row that establish another clock, >= 1. Own choice.
};

/// The one time of all nodes. A stamp within the tolerance is trusted. A node whose stamps stay farther off
/// while others are heard has a clock of its own, and is shifted; where nobody else is heard, time itself has
/// passed (a pause of all), or run backwards (a restart: everything begins anew). A single wild stamp is
/// refused.
class FusionClock {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit FusionClock(const FusionClockParams& params);

  /// What the clock makes of one time stamp.
  struct Reading {
    std::optional<std::int64_t> utime;  ///< On the common clock [us]; nothing: refused.
    bool restarted = false;             ///< The common clock begins anew with this message.
  };

  /// Places a message of `node_id`, stamped `utime` [us] by its clock, on the common clock.
  Reading read(std::int32_t node_id, std::int64_t utime);

  /// Newest time accepted [us]; nothing before the first message.
  std::optional<std::int64_t> now() const { return now_; }
  /// What is added to a node's stamps [us]; 0 of a node that keeps the common clock.
  std::int64_t offset(std::int32_t node_id) const;

 private:
  struct Node {
    std::int64_t offset = 0;
    std::int64_t outlier = 0;  ///< Its newest stamp that did not fit.
    int outliers = 0;          ///< How many in a row that fit one another.
    bool alone = true;         ///< Whether nobody else has been heard since the first of them.
  };

  Reading accept(Node& node, std::int32_t node_id, std::int64_t utime);
  Reading settle(Node& node, std::int32_t node_id, std::int64_t utime);
  bool close(std::int64_t a, std::int64_t b) const;

  FusionClockParams params_;
  std::optional<std::int64_t> now_;
  std::map<std::int32_t, Node> nodes_;
};

}  // namespace lookout::fusion
