#include "core/files/time_text.hpp"

#include <charconv>
#include <cmath>

#include "core/frames.hpp"

namespace lookout::core {
namespace {

constexpr std::int64_t kPerSecond = 1'000'000;
constexpr std::size_t kDecimals = 6;

template <class Number>
std::optional<Number> whole(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool all_digits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Of "12.345" without its sign: 12345000. Nothing for other forms, which a double serves well enough.
std::optional<std::int64_t> plain_decimal(std::string_view text) {
  const std::size_t point = text.find('.');
  const std::string_view units = text.substr(0, point);
  const std::string_view rest = point == std::string_view::npos ? "" : text.substr(point + 1);
  if (units.empty() || rest.size() > kDecimals || !all_digits(units) || !all_digits(rest))
    return std::nullopt;
  std::string digits(units);
  digits.append(rest).append(kDecimals - rest.size(), '0');
  return whole<std::int64_t>(digits);
}

}  // namespace

std::string time_text(std::int64_t utime) {
  const bool negative = utime < 0;
  const std::uint64_t size =
      negative ? 0 - static_cast<std::uint64_t>(utime) : static_cast<std::uint64_t>(utime);
  std::string text = negative ? "-" : "";
  text.append(std::to_string(size / kPerSecond)).append(1, '.');
  const std::string decimals = std::to_string(size % kPerSecond);
  text.append(kDecimals - decimals.size(), '0').append(decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::optional<std::int64_t> parse_time(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto seconds = whole<double>(text);
  if (!seconds || !(std::abs(*seconds) * kPerSecond <= static_cast<double>(kMaxUtime))) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (const auto exact = plain_decimal(text.substr(negative ? 1 : 0))) return negative ? -*exact : *exact;
  return microseconds(*seconds);
}

double stated_resolution(std::string_view text) {
  const std::size_t exponent = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, exponent);
  std::string_view power = exponent == std::string_view::npos ? "0" : text.substr(exponent + 1);
  if (power.starts_with('+')) power.remove_prefix(1);
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  return std::pow(10.0, whole<int>(power).value_or(0) - static_cast<double>(decimals));
}

}  // namespace lookout::core
