#include "tools/watch/event_hub.hpp"

#include <utility>

namespace lookout::tools {

void EventHub::publish(Topic topic, std::string text) {
  auto shared = std::make_shared<const std::string>(std::move(text));
  {
    const std::lock_guard lock(mutex_);
    Slot& slot = slots_[static_cast<std::size_t>(topic)];
    ++slot.version;
    slot.text = std::move(shared);
  }
  changed_.notify_all();
}

std::vector<EventHub::News> EventHub::newer_than(Seen& seen) const {
  std::vector<News> news;
  for (std::size_t topic = 0; topic < kNumTopics; ++topic) {
    if (slots_[topic].version == seen[topic]) continue;
    seen[topic] = slots_[topic].version;
    news.push_back({static_cast<Topic>(topic), slots_[topic].text});
  }
  return news;
}

std::vector<EventHub::News> EventHub::wait_for_news(Seen& seen, std::chrono::milliseconds timeout) {
  std::vector<News> news;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [&] {
    if (!closed_) news = newer_than(seen);
    return closed_ || !news.empty();
  });
  return news;
}

void EventHub::keep_trails(std::string text) {
  auto shared = std::make_shared<const std::string>(std::move(text));
  const std::lock_guard lock(mutex_);
  trails_ = std::move(shared);
}

EventHub::Text EventHub::trails() const {
  const std::lock_guard lock(mutex_);
  return trails_;
}

void EventHub::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

bool EventHub::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

}  // namespace lookout::tools
