#pragma once

namespace lookout::lcmtypes {

/// Bytes of one LOCAL_ESTIMATE on the link: LCM's header of a small message, which holds the channel's name,
/// and what the encoder makes of an estimate.
int local_estimate_bytes(bool with_covariance);

}  // namespace lookout::lcmtypes
