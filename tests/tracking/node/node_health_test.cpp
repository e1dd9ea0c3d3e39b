#include "tracking/node/node_health.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// A sonar at two scans a second and its navigation at four states, without a fault.
class NodeHealthTest : public ::testing::Test {
 protected:
  void seconds(int count) {
    for (int i = 0; i < count; ++i) {
      sample_.pings += pings_;
      sample_.states += states_;
      sample_.returns += 100;
      health_.add(sample_);
    }
  }
  HealthSample sample_;
  int pings_ = 2, states_ = 4;
  NodeHealth health_;
};

TEST_F(NodeHealthTest, HasNoDataUntilSomethingComes) {
  EXPECT_EQ(health_.state(), NodeState::no_data);
  pings_ = 0;
  seconds(1);
  EXPECT_EQ(health_.text(), "no data: no scan heard yet");
  pings_ = 2;
  seconds(1);
  EXPECT_EQ(health_.text(), "healthy");
}

TEST_F(NodeHealthTest, SilenceIsToldAfterFiveSecondsAndASlowSonarsLater) {
  seconds(3);
  states_ = 0;
  seconds(5);
  EXPECT_EQ(health_.state(), NodeState::healthy);
  seconds(1);
  EXPECT_EQ(health_.text(), "no data: no vehicle state for 6 s");
  states_ = 4;
  for (int i = 0; i < 3; ++i) {  // A scan every five seconds: silent for three times four others.
    pings_ = 1;
    seconds(1);
    pings_ = 0;
    seconds(4);
  }
  seconds(8);
  EXPECT_EQ(health_.state(), NodeState::healthy);
  seconds(1);
  EXPECT_EQ(health_.text(), "no data: no scan for 13 s");
}

TEST_F(NodeHealthTest, OverloadComesBeforeLossAndBothAreForgottenAfterTenSeconds) {
  seconds(3);
  sample_.shed += 5;
  sample_.lost += 2;
  seconds(1);
  EXPECT_EQ(health_.text(), "overloaded: 5 scans shed in 10 s; 2 scans lost in 10 s");
  seconds(10);
  EXPECT_EQ(health_.text(), "healthy");
}

TEST_F(NodeHealthTest, SaysWhyItIsDegraded) {
  seconds(1);
  sample_.rejected += 1;
  sample_.send_errors += 1;
  sample_.twins += 1;
  sample_.repeated += 1;
  sample_.restarts += 3;
  seconds(1);
  EXPECT_EQ(health_.state(), NodeState::degraded);
  for (const char* reason :
       {"1 messages refused", "1 messages not sent", "another tracker", "repeats itself", "two senders"})
    EXPECT_NE(health_.text().find(reason), std::string::npos) << reason;
}

TEST_F(NodeHealthTest, ScansWithTooManyReturnsAreOverload) {
  seconds(3);
  sample_.crowded += 2;
  sample_.shed_returns += 3352;
  seconds(1);
  EXPECT_EQ(health_.text(), "overloaded: 2 scans with too many returns in 10 s: 3352 left out");
}

TEST_F(NodeHealthTest, FindsReturnsAndFiguresImplausible) {
  seconds(1);
  sample_.dropped_returns += 400;
  seconds(1);
  EXPECT_NE(health_.text().find("implausible: many returns"), std::string::npos);
  seconds(10);
  EXPECT_EQ(health_.state(), NodeState::healthy);
  sample_.contradicting += 1;
  seconds(1);
  EXPECT_NE(health_.text().find("implausible: scans contradict"), std::string::npos);
  seconds(10);
  sample_.off_pace += 1;
  seconds(1);
  EXPECT_NE(health_.text().find("no sonar's pace: milliseconds for microseconds?"), std::string::npos);
  seconds(10);
  sample_.wide_headings += 1;
  seconds(1);
  EXPECT_NE(health_.text().find("degrees?"), std::string::npos);
  seconds(10);
  sample_.miss_probability = 0.97;
  seconds(1);
  EXPECT_NE(health_.text().find("implausible: nearly every echo"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tracking
