#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace lookout::fusion {

/// Which time stamps belong to one clock. Four things are told apart: how far honest clocks differ, how long
/// messages travel, how seldom a node reports, and a clock of another zero.
struct FusionClockParams {
  double tolerance = 5.0;   ///< Of clocks: a stamp may run ahead of the newest, or behind the newest of its
                            ///< own node, by so much [s], > 0. Own choice.
  double max_delay = 30.0;  ///< Of links: an honest message may be so old on arrival [s], >= tolerance; an
                            ///< older one tells of another clock. Own choice.
  double max_interval = 60.0;  ///< Of rates: a node may be silent for so long between two messages [s], > 0:
                               ///< the slowest turn of an acoustic link.
  std::size_t max_nodes = 64;  ///< Nodes that are known at one time, >= 1: bounds the memory. Own choice.
  int consistent = 3;          ///< Messages in a row that establish another clock, >= 1. Own choice.
};

/// The one time of all nodes. It goes on with the newest stamp; later arrivals are late, not wrong. A node
/// whose stamps stay outside of what clock, link and rate allow while others are heard has a clock of its
/// own, and is shifted; where nobody else is heard, time itself has passed (a pause of all), or run backwards
/// (a restart: everything begins anew). A single wild stamp is refused.
class FusionClock {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit FusionClock(const FusionClockParams& params);

  /// What the clock makes of one time stamp.
  struct Reading {
    std::optional<std::int64_t> utime;  ///< On the common clock [us]; nothing: refused.
    bool restarted = false;             ///< The common clock begins anew with this message.
    bool is_full = false;               ///< Refused: as many nodes are known as may be.
  };

  /// Places a message of `node_id`, stamped `utime` [us] by its clock, on the common clock.
  Reading read(std::int32_t node_id, std::int64_t utime);

  /// Tells a late node from one whose clock is behind, which the stamps alone cannot: what it reports agrees
  /// with the picture either at its stamp or at its arrival.
  /// @param for_delay > 0 where the message agrees better at its stamp, < 0 at its arrival, in [-1, 1].
  /// Five messages' worth of the latter set the node's offset; a node that is not late is left as it is.
  void judge(std::int32_t node_id, double for_delay);

  /// Newest time accepted [us]; nothing before the first message.
  std::optional<std::int64_t> now() const { return now_; }
  /// What is added to a node's stamps [us]; 0 of a node that keeps the common clock.
  std::int64_t offset(std::int32_t node_id) const;
  /// How old a node's messages are on arrival, running mean [s]; 0 of a node not heard.
  double delay(std::int32_t node_id) const;
  double tolerance() const { return params_.tolerance; }  ///< Of clocks [s].

 private:
  struct Node {
    std::int64_t offset = 0;
    std::optional<std::int64_t> newest;  ///< Newest stamp accepted, on the common clock.
    double interval = 0.0;               ///< Between its messages, running mean [s]; 0: not known.
    double delay = 0.0;                  ///< Running mean [s].
    double for_delay = 0.0;              ///< Sum of what `judge` was told.
    std::int64_t outlier = 0;            ///< Its newest stamp that did not fit.
    int outliers = 0;                    ///< How many in a row that fit one another.
    double step = 0.0;                   ///< Between the last two of them [s].
    bool alone = true;                   ///< Whether nobody else has been heard since the first of them.
  };

  bool has_room_for(std::int32_t node_id);
  bool fits(const Node& node, std::int64_t utime) const;
  void note_outlier(Node& node, std::int64_t utime);
  bool another_agrees(std::int32_t node_id, const Node& node, std::int64_t utime) const;
  Reading accept(Node& node, std::int32_t node_id, std::int64_t utime);
  Reading pass_time(Node& node, std::int32_t node_id, std::int64_t utime);
  Reading settle(Node& node, std::int32_t node_id, std::int64_t utime);
  void learn(Node& node, std::int64_t utime) const;

  FusionClockParams params_;
  std::optional<std::int64_t> now_;
  std::map<std::int32_t, Node> nodes_;
};

}  // namespace lookout::fusion
