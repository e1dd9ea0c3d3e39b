#include "lcmtypes/message_size.hpp"

#include <gtest/gtest.h>

namespace lookout::lcmtypes {
namespace {

// Header 8 + 14 + 1; fingerprint, utime, sequence 3 x 8, node 4, its position 2 x 8, track 8, state 4 x 8,
// count 2.
TEST(MessageSize, ALocalEstimateTakes109Bytes) {
  EXPECT_EQ(local_estimate_bytes(false), 23 + 86);
}

TEST(MessageSize, ACovarianceAddsSixteenNumbers) {
  EXPECT_EQ(local_estimate_bytes(true) - local_estimate_bytes(false), 16 * 8);
}

}  // namespace
}  // namespace lookout::lcmtypes
