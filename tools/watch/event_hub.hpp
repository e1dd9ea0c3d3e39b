#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tools/watch/heard.hpp"

namespace lookout::tools {

/// Where the listener leaves its news and the browsers' streams find them: the newest text of each topic and
/// no queue, so that a slow reader misses what was in between and nobody waits for it. For several threads.
class EventHub {
 public:
  using Text = std::shared_ptr<const std::string>;
  using Seen = std::array<std::uint64_t, kNumTopics>;  ///< What a reader has had; starts with zeros.

  struct News {
    Topic topic = Topic::vehicle;
    Text text;
  };

  /// Replaces the newest of the topic. Never waits for a reader.
  void publish(Topic topic, std::string text);

  /// What is newer than `seen`, which is brought up to it; empty after `timeout` or once closed.
  std::vector<News> wait_for_news(Seen& seen, std::chrono::milliseconds timeout);

  void keep_trails(std::string text);  ///< For `trails`, asked for and not streamed.
  Text trails() const;

  void close();  ///< Wakes all readers for good.
  bool closed() const;

 private:
  struct Slot {
    std::uint64_t version = 0;
    Text text;
  };
  std::vector<News> newer_than(Seen& seen) const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::array<Slot, kNumTopics> slots_;
  Text trails_ = std::make_shared<const std::string>("{}");
  bool closed_ = false;
};

}  // namespace lookout::tools
