#include "tools/import/lenient_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

constexpr char kFiller = '~';

bool is_word(char letter) {
  return std::string_view("+-.").find(letter) != std::string_view::npos || (letter >= '0' && letter <= '9') ||
         (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

bool is_not_finite(const std::string& word) {
  if (word == "NaN" || word == "Infinity" || word == "-Infinity") return true;
  const bool is_number = word.find_first_not_of("+-.0123456789eE") == std::string::npos;
  return is_number && std::isinf(std::strtod(word.c_str(), nullptr));
}

/// The end of the string that begins at `at`.
std::size_t end_of_string(const std::string& text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return std::min(text.size(), at + 1);
}

/// Puts a text of the same length, so that lines and columns stay, in the place of each number that JSON does
/// not have.
void quote_what_is_not_finite(std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '"') {
      at = end_of_string(text, at);
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    if (end > at && is_not_finite(text.substr(at, end - at))) {
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
                text.begin() + static_cast<std::ptrdiff_t>(end), kFiller);
      text[at] = text[end - 1] = '"';
    }
    at = std::max(end, at + 1);
  }
}

std::string place_of(const std::string& text, std::size_t byte) {
  const std::string_view before(text.data(), std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return std::to_string(line) + ":" + std::to_string(before.size() - begin);
}

}  // namespace

nlohmann::json parse_lenient(std::string text, const std::string& name) {
  quote_what_is_not_finite(text);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw core::InputError(name + ":" + place_of(text, error.byte) + ": not JSON");
  } catch (const nlohmann::json::exception&) {
    throw core::InputError(name + ": not JSON");
  }
}

std::optional<double> lenient_number(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  if (text.empty() || text.find_first_not_of(kFiller) != std::string::npos) return std::nullopt;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace lookout::tools
