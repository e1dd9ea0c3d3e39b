#include "core/files/text_file.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/files/input_bytes.hpp"
#include "core/input_error.hpp"

namespace lookout::core {
namespace {

constexpr std::size_t kLongestShown = 60;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

std::string read_text_file(const std::string& path, std::string_view expected) {
  std::string text = input_bytes(path, expected);
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv))
    throw InputError(path + ": is UTF-32 text; save it as UTF-8 (iconv -f UTF-32 -t UTF-8)");
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError(path + ": is UTF-16 text; save it as UTF-8 (iconv -f UTF-16 -t UTF-8)");
  if (text.find('\0') != std::string::npos)
    throw InputError(path + ": holds a zero byte: binary or UTF-16; expected " + std::string(expected) +
                     " in UTF-8");
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

std::string shown(std::string_view value) {
  std::string text = "`";
  for (const char letter : value.substr(0, kLongestShown))
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  return text + (value.size() > kLongestShown ? "...`" : "`");
}

void require_plain_target(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(path + ": is " + (std::filesystem::is_directory(status) ? "a directory" : "a device") +
                     "; expected a plain file to write");
}

void write_text_file(const std::string& path, std::string_view text) {
  require_plain_target(path);
  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be written");
  file << text;
  file.close();
  std::error_code failed;
  if (file) std::filesystem::rename(part, path, failed);
  if (file && !failed) return;
  std::filesystem::remove(part, failed);
  throw std::runtime_error(path + ": could not be written completely");
}

}  // namespace lookout::core
