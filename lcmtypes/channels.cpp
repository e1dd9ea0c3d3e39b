#include "lcmtypes/channels.hpp"

#include <algorithm>
#include <cctype>

#include "core/input_error.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr std::size_t kLongestPrefix = 32;  // LCM's channel names end at 63 characters.

bool is_plain(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("_./-").find(letter) != std::string_view::npos;
}

}  // namespace

Channels::Channels(std::string_view prefix) : prefix_(prefix) {
  if (prefix.size() <= kLongestPrefix && std::all_of(prefix.begin(), prefix.end(), is_plain)) return;
  throw core::InputError("--channel-prefix: got `" + prefix_ +
                         "`, expected at most 32 letters, digits, `_`, `.`, `/` or `-`");
}

}  // namespace lookout::lcmtypes
