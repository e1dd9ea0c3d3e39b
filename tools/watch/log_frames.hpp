#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "tools/watch/heard.hpp"

namespace lookout::tools {

/// An LCM log as pictures that can be asked for in any order. It holds where each message stands, not the
/// messages: 16 bytes each. Its const functions may be called from several threads.
class LogFrames {
 public:
  using OnDecisions = std::function<void(const lcmtypes::DecisionReport&)>;

  /// Reads the log once, checks every message, and hands those of DECISIONS on.
  /// @throws core::InputError where it is no readable log, or holds no channel of ours.
  LogFrames(
      const std::string& path, const std::string& channel_prefix,
      const OnDecisions& on_decisions = [](const lcmtypes::DecisionReport&) {});
  ~LogFrames();
  LogFrames(const LogFrames&) = delete;
  LogFrames& operator=(const LogFrames&) = delete;

  /// One frame for each TRACKS message; of a log without tracks for each scan, image or vehicle state.
  std::size_t size() const { return frames_.size(); }

  /// What was newest of each topic at frame `n` < size(), as picture_json has it: {"vehicle": {...}, ...}.
  nlohmann::json frame(std::size_t n) const;

  /// Where the tracks were in the 30 s before frame `n`.
  nlohmann::json trails(std::size_t n) const;

  /// Messages that no picture shows, by channel and reason.
  const std::vector<lcmtypes::Refusal>& refusals() const { return refusals_; }
  std::int64_t damages() const { return damages_; }  ///< Stretches of the log that could not be read.

 private:
  struct Place {
    std::int64_t offset = 0;
    std::uint32_t size = 0;
    std::uint32_t order = 0;  ///< Of the message in the log.
  };
  struct Choice {
    Place place;
    std::string channel;
  };
  void index(const std::string& path, const OnDecisions& on_decisions);
  std::vector<Choice> newest_at(std::uint32_t order) const;
  std::vector<std::uint8_t> bytes_at(const Place& place) const;

  std::string path_, prefix_;
  std::map<std::string, std::vector<Place>> places_;  ///< By channel, in the order of the log.
  std::vector<std::uint32_t> frames_;                 ///< The order of the message that completes each.
  std::string frame_channel_;
  std::vector<lcmtypes::Refusal> refusals_;
  std::int64_t damages_ = 0;
  int file_ = -1;
};

}  // namespace lookout::tools
