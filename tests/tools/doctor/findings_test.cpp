#include "tools/doctor/findings.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

using Verdict = Finding::Verdict;

TEST(Findings, TakeAnUrlApartAsLcmDoes) {
  const MulticastUrl url = parse_multicast("udpm://239.1.2.3:7000?ttl=1&recv_buf_size=4096");
  EXPECT_EQ(url.address, "239.1.2.3");
  EXPECT_EQ(url.port, 7000);
  EXPECT_EQ(url.ttl, 1);
  EXPECT_EQ(url.receive_buffer, 4096);
  EXPECT_EQ(parse_multicast("udpm://").address, "239.255.76.67");
  EXPECT_EQ(parse_multicast("udpm://239.1.2.3").port, 7667);
  EXPECT_EQ(parse_multicast("udpm://?ttl=2").ttl, 2);
}

TEST(Findings, WithoutARouteNothingCanBeSent) {
  const Finding finding = judge_route({}, {});
  EXPECT_EQ(finding.verdict, Verdict::failure);
  EXPECT_NE(finding.cure.find("ip route add 224.0.0.0/4"), std::string::npos);
  EXPECT_EQ(judge_route({}, {true, false, "eth0"}).what, "239.255.76.67 by eth0");
}

TEST(Findings, ATtlAboveZeroOnTheLoopbackReachesNobody) {
  const MulticastUrl far{"239.255.76.67", 7667, 1, 0};
  EXPECT_EQ(judge_ttl(far, {true, true, "lo"}).verdict, Verdict::failure);
  EXPECT_NE(judge_ttl(far, {true, true, "lo"}).cure.find("ttl=0"), std::string::npos);
  EXPECT_EQ(judge_ttl(far, {true, false, "eth0"}).verdict, Verdict::remark);
  EXPECT_EQ(judge_ttl({}, {true, true, "lo"}).verdict, Verdict::ok);
}

// The largest message is 65,499 bytes; the kernel counts about twice what it holds.
TEST(Findings, ABufferMustHoldTheLargestMessage) {
  EXPECT_EQ(judge_buffer({}, 212'992, 212'992).verdict, Verdict::ok);  // Linux's own choice.
  const MulticastUrl small{"239.255.76.67", 7667, 0, 4096};
  const Finding by_url = judge_buffer(small, 8192, 212'992);
  EXPECT_EQ(by_url.verdict, Verdict::failure);
  EXPECT_NE(by_url.cure.find("recv_buf_size"), std::string::npos);
  EXPECT_NE(judge_buffer({}, 8192, 8192).cure.find("sysctl -w net.core.rmem_max"), std::string::npos);
}

TEST(Findings, WhatIsSentMustBeHeardWhole) {
  EXPECT_EQ(judge_link({10, 10, 2, 2, 2, 2, {}}).verdict, Verdict::ok);
  EXPECT_EQ(judge_link({10, 10, 2, 1, 2, 2, {}}).verdict, Verdict::failure);
  EXPECT_EQ(judge_link({10, 10, 2, 2, 2, 1, {}}).verdict, Verdict::remark);
  EXPECT_NE(judge_link({10, 10, 2, 2, 2, 1, {}}).what.find("fragments are lost"), std::string::npos);
  EXPECT_NE(judge_link({10, 0, 2, 0, 2, 0, {}}).cure.find("iptables"), std::string::npos);
  EXPECT_EQ(judge_link({0, 0, 0, 0, 0, 0, "no way"}).what, "no way");
}

TEST(Findings, SilenceIsARemarkAndForeignTypesAFailure) {
  EXPECT_EQ(judge_traffic({}).verdict, Verdict::remark);
  EXPECT_EQ(judge_traffic({5, 10, 0, 0, {}}).verdict, Verdict::ok);
  EXPECT_EQ(judge_traffic({5, 10, 0, 1, {}}).verdict, Verdict::failure);
  const Finding foreign = judge_traffic({5, 10, 3, 0, "SONAR_SCAN: not one whole message of its type"});
  EXPECT_EQ(foreign.verdict, Verdict::failure);
  EXPECT_NE(foreign.what.find("SONAR_SCAN"), std::string::npos);
}

TEST(Findings, JudgeTheMachine) {
  EXPECT_EQ(judge_clock(1970, true).verdict, Verdict::failure);
  EXPECT_EQ(judge_clock(2026, false).verdict, Verdict::remark);
  EXPECT_EQ(judge_clock(2026, true).verdict, Verdict::ok);
  EXPECT_EQ(judge_directory("output", "/x", "is no directory").verdict, Verdict::failure);
  EXPECT_EQ(judge_disk("/x", 1'000'000).verdict, Verdict::failure);
  EXPECT_EQ(judge_disk("/x", 1'000'000'000).verdict, Verdict::ok);
  EXPECT_EQ(judge_jar("").cure, "tools/spy");
}

TEST(Findings, EveryLineSaysHowItIsAndWhatToType) {
  EXPECT_EQ(line_of({Verdict::ok, "route", "by lo", {}}), "ok      route: by lo");
  EXPECT_EQ(line_of({Verdict::failure, "route", "none", "type this"}),
            "FAILURE route: none\n          -> type this");
}

}  // namespace
}  // namespace lookout::tools
