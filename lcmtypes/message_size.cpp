#include "lcmtypes/message_size.hpp"

#include <string_view>

#include "lcmtypes/channels.hpp"
#include "lcmtypes/convert.hpp"

namespace lookout::lcmtypes {
namespace {

/// LCM's small message: magic and sequence number of four bytes each, the channel's name and its zero.
int small_header_bytes(std::string_view channel) {
  constexpr int kMagicAndSequence = 8;
  return kMagicAndSequence + static_cast<int>(channel.size()) + 1;
}

}  // namespace

int local_estimate_bytes(bool with_covariance) {
  core::LocalEstimate estimate;
  if (with_covariance) estimate.covariance = Eigen::Matrix4d::Identity();
  return small_header_bytes(Channels::kLocalEstimate) + to_wire(estimate).getEncodedSize();
}

}  // namespace lookout::lcmtypes
