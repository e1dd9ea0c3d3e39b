#include "tools/watch/event_hub.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace lookout::tools {
namespace {

using std::chrono::milliseconds;

TEST(EventHub, KeepsTheNewestOfATopicAlone) {
  EventHub hub;
  EventHub::Seen seen{};
  for (int k = 0; k < 1000; ++k) hub.publish(Topic::scan, std::to_string(k));
  hub.publish(Topic::tracks, "tracks");
  const auto news = hub.wait_for_news(seen, milliseconds(0));
  ASSERT_EQ(news.size(), 2u);
  EXPECT_EQ(*news[0].text, "999");
  EXPECT_EQ(*news[1].text, "tracks");
  EXPECT_TRUE(hub.wait_for_news(seen, milliseconds(0)).empty());
}

TEST(EventHub, GivesEachReaderTheSame) {
  EventHub hub;
  hub.publish(Topic::scan, "one");
  for (int reader = 0; reader < 2; ++reader) {
    EventHub::Seen seen{};
    EXPECT_EQ(hub.wait_for_news(seen, milliseconds(0)).size(), 1u);
  }
}

TEST(EventHub, WakesAReaderWithNewsAndWhenItCloses) {
  EventHub hub;
  EventHub::Seen seen{};
  std::thread writer([&hub] { hub.publish(Topic::scan, "one"); });
  EXPECT_EQ(hub.wait_for_news(seen, milliseconds(10'000)).size(), 1u);
  writer.join();
  std::thread closer([&hub] { hub.close(); });
  EXPECT_TRUE(hub.wait_for_news(seen, milliseconds(10'000)).empty());
  closer.join();
  EXPECT_TRUE(hub.closed());
}

}  // namespace
}  // namespace lookout::tools
