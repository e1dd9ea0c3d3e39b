#include "tools/experiments/harness/shard.hpp"

#include <charconv>
#include <optional>

#include "core/files/text_file.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

constexpr int kMostShards = 100'000;

/// A whole number, nothing else before or behind it.
std::optional<int> as_integer(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string Shard::text() const {
  std::string result = std::to_string(index);
  return result.append("/").append(std::to_string(count));
}

Shard parse_shard(const std::string& text) {
  if (text.empty()) return {};
  const auto slash = text.find('/');
  const auto index = as_integer(text.substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : as_integer(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count || *count > kMostShards)
    throw core::InputError("--shard: got " + core::shown(text) +
                           ", expected K/N with 1 <= K <= N <= " + std::to_string(kMostShards));
  return {*index, *count};
}

}  // namespace lookout::tools
