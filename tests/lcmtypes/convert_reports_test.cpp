#include "lcmtypes/convert_reports.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <lookout/node_status_t.hpp>
#include <lookout/ospa_t.hpp>
#include <vector>

#include "core/frames.hpp"

namespace lookout::lcmtypes {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Wire>
Bytes encoded(const Wire& wire) {
  Bytes bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

Bytes example_status(const std::string& node, const std::string& last_error) {
  node_status_t wire{};
  wire.utime = 5;
  wire.node_id = 3;
  wire.accepted = 10;
  wire.rejected = 2;
  wire.latency_ms_p99 = 7.5;
  wire.node = node;
  wire.last_error = last_error;
  return encoded(wire);
}

TEST(ReadNodeStatus, GivesFiguresAndTexts) {
  const auto status = read_node_status(example_status("lookout track", "no pose"));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->node_id, 3);
  EXPECT_EQ(status->accepted, 10);
  EXPECT_EQ(status->rejected, 2);
  EXPECT_EQ(status->latency_ms_p99, 7.5);
  EXPECT_EQ(status->node, "lookout track");
  EXPECT_EQ(status->last_error, "no pose");
}

TEST(ReadNodeStatus, TakesNoTruncationAndNoTrailingByte) {
  Bytes bytes = example_status("lookout track", "no pose");
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read_node_status(std::span(bytes).first(size))) << size;
  bytes.push_back(0);
  EXPECT_FALSE(read_node_status(bytes));
}

TEST(ReadNodeStatus, SurvivesEveryChangedByteAndAnyLengthOfAText) {
  const Bytes good = example_status("ab", "c");
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int value : {0x00, 0x7f, 0x80, 0xff}) {
      Bytes bytes = good;
      bytes[at] = static_cast<std::uint8_t>(value);
      const auto status = read_node_status(bytes);
      EXPECT_LE(status ? status->node.size() : 0, kMaxShownText);
    }
  }
}

TEST(ReadNodeStatus, KeepsTextsShortAndPrintable) {
  const auto status = read_node_status(example_status("a\x1b[2J\n", std::string(5000, 'x')));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->node, "a?[2J?");
  EXPECT_EQ(status->last_error.size(), kMaxShownText);
}

TEST(ReadOspa, GivesTheReportAndRefusesDamage) {
  ospa_t wire{};
  wire.total = 1.5;
  wire.num_truth = 3;
  const auto report = read_ospa(encoded(wire));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->total, 1.5);
  EXPECT_EQ(report->num_truth, 3);
  wire.total = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(read_ospa(encoded(wire)));
  EXPECT_FALSE(read_ospa(Bytes(10, 0)));
}

TEST(ReadDecisions, GivesTheLinesAndNothingThatCannotBePrinted) {
  const auto report = read_decisions(encoded(to_wire({5, 6, 7, "a\nb\x1b[1m\n"})));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->utime, 5);
  EXPECT_EQ(report->sequence, 6);
  EXPECT_EQ(report->source_id, 7);
  EXPECT_EQ(report->text, "a\nb?[1m\n");
}

TEST(ReadDecisions, TakesNoTruncationNoTrailingByteAndNoOtherCount) {
  Bytes bytes = encoded(to_wire({5, 6, 7, "a\n"}));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read_decisions(std::span(bytes).first(size))) << size;
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(read_decisions(longer));
  bytes[bytes.size() - 4] = 0xff;  // The count, which stands before the two characters: negative.
  EXPECT_FALSE(read_decisions(bytes));
  EXPECT_FALSE(read_decisions(encoded(to_wire({core::kMaxUtime + 1, 6, 7, "a\n"}))));
}

}  // namespace
}  // namespace lookout::lcmtypes
