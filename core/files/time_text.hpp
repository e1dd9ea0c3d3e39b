#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// The one place where times become text and text becomes times: microseconds, exactly.
namespace lookout::core {

/// Scenario time [us] as seconds in decimals without an exponent, no digit more than it has: 107438450 is
/// "107.43845", 1700000000000000 is "1700000000".
std::string time_text(std::int64_t utime);

/// Seconds in text as microseconds, to the microsecond for any plain decimal number, rounded beyond that.
/// @return nothing where `text` is no finite number or beyond `kMaxUtime`.
std::optional<std::int64_t> parse_time(std::string_view text);

/// The unit of the last digit that `text`, a number, states [s]: 1e8 of "1.7e+09", .001 of "0.250".
double stated_resolution(std::string_view text);

}  // namespace lookout::core
