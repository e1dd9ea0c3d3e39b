#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lookout::tracking {

/// What a node has counted since its start.
struct HealthSample {
  std::int64_t pings = 0;            ///< Scans or images that came.
  std::int64_t states = 0;           ///< Vehicle states that came.
  std::int64_t rejected = 0;         ///< Messages refused, for whatever reason.
  std::int64_t lost = 0;             ///< Pings that never came.
  std::int64_t restarts = 0;         ///< Times that a sender's numbers started again.
  std::int64_t shed = 0;             ///< Pings left out under overload.
  std::int64_t send_errors = 0;      ///< Messages that the system refused to send.
  std::int64_t returns = 0;          ///< Of accepted pings, those left out included.
  std::int64_t dropped_returns = 0;  ///< Of those, out of bounds.
  std::int64_t crowded = 0;          ///< Accepted pings with more returns than are tracked,
  std::int64_t shed_returns = 0;     ///< and those that were left out of them.
  std::int64_t contradicting = 0;    ///< Pings refused for what they contradict.
  std::int64_t repeated = 0;         ///< Pings with the content of the one before.
  std::int64_t off_pace = 0;         ///< Pings a hundred times too fast or slow by their stamps.
  std::int64_t wide_headings = 0;    ///< Vehicle states with a heading beyond two turns.
  std::int64_t twins = 0;            ///< Statuses of another tracker with our channel and node id.
  double miss_probability = 0.0;     ///< The newest that was learnt, not since the start; 0: nothing learnt.
};

/// How a node does, in one word.
enum class NodeState { no_data, overloaded, degraded, healthy };

/// "no data", "overloaded", "degraded", "healthy".
const char* to_string(NodeState state);

/// Judges a node by what it counted, a sample a second. What is wrong is remembered for ten of them.
class NodeHealth {
 public:
  static constexpr std::size_t kWindow = 10;        ///< Samples.
  static constexpr int kSilence = 5;                ///< Samples without input that are too many.
  static constexpr double kMostOutOfBounds = 0.2;   ///< Share of returns; more are not this sonar's.
  static constexpr std::int64_t kMostRestarts = 2;  ///< Of a sender; more are two senders.
  static constexpr double kMostMissed = 0.9;        ///< Learnt P_M; above it targets are not where told.

  void add(const HealthSample& sample);  ///< One second has passed.

  NodeState state() const { return state_; }  ///< "no data" before the first sample.
  /// The state and, where it is not healthy, why: "degraded: 3 scans lost in 10 s; the sonar repeats itself".
  std::string text() const;

 private:
  HealthSample change() const;
  void judge();
  void judge_input();
  void judge_overload(const HealthSample& recent);
  void judge_quality(const HealthSample& recent);
  void judge_content(const HealthSample& recent);
  void blame(NodeState state, const std::string& reason);
  int longest_silence() const;

  std::array<HealthSample, kWindow + 1> samples_{};  ///< A ring; before the first all is 0.
  std::size_t newest_ = 0;
  int silent_pings_ = 0, silent_states_ = 0;  ///< Samples since the newest came.
  int longest_gap_ = 0;                       ///< Samples between pings that did come.
  NodeState state_ = NodeState::no_data;
  std::vector<std::string> reasons_{"nothing heard yet"};
};

}  // namespace lookout::tracking
