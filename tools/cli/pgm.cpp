#include "tools/cli/pgm.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

/// The usual difference of frame times may be so much above the least: less regular times are taken by the
/// least.
constexpr double kSteadyCount = 1.5;
constexpr std::array<std::string_view, 1> kGrey{".pgm"};
constexpr std::array<std::string_view, 2> kPictures{".pgm", ".ppm"};
constexpr double kLongestGap = 1e6;  // Frames; more is a mistake of names, not silence.

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

bool is_digit(char letter) {
  return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

/// Takes a run of digits off `text`, without its leading zeros.
std::string_view take_digits(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

/// The last number of a stem, with decimals where it has a point; nothing where it has none.
std::optional<double> last_number(const std::string& stem) {
  const auto begin_of_digits = [&stem](std::size_t end) {
    while (end > 0 && is_digit(stem[end - 1])) --end;
    return end;
  };
  std::size_t end = stem.size();
  while (end > 0 && !is_digit(stem[end - 1])) --end;
  std::size_t begin = begin_of_digits(end);
  if (begin == end) return std::nullopt;
  if (begin > 1 && stem[begin - 1] == '.' && is_digit(stem[begin - 2])) begin = begin_of_digits(begin - 1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(stem.data() + begin, stem.data() + end, value);
  return error == std::errc() && stop == stem.data() + end ? std::optional(value) : std::nullopt;
}

FrameNumbers plain_count(std::size_t size, const std::string& note) {
  FrameNumbers numbers{std::vector<std::int64_t>(size), note};
  std::iota(numbers.index.begin(), numbers.index.end(), std::int64_t{0});
  return numbers;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = take_digits(a), y = take_digits(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

FrameNumbers frame_numbers(std::span<const std::string> stems) {
  std::vector<double> numbers, differences;
  for (const std::string& stem : stems) {
    const auto number = last_number(stem);
    if (!number) return plain_count(stems.size(), "");
    if (!numbers.empty()) differences.push_back(*number - numbers.back());
    if (!differences.empty() && !(differences.back() > 0.0))
      return plain_count(stems.size(), "the numbers in the names repeat or go back at " + stem +
                                           ": frames are counted in order of name");
    numbers.push_back(*number);
  }
  if (differences.empty()) return plain_count(stems.size(), "");
  // The least differences, averaged: names that are times have some jitter.
  const double limit = kSteadyCount * *std::min_element(differences.begin(), differences.end());
  const auto end_of_least =
      std::partition(differences.begin(), differences.end(), [limit](double d) { return d <= limit; });
  const double unit = std::accumulate(differences.begin(), end_of_least, 0.0) /
                      static_cast<double>(end_of_least - differences.begin());
  FrameNumbers result;
  result.index.push_back(0);
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double steps = std::max(1.0, std::round((numbers[i] - numbers[i - 1]) / unit));
    if (!(steps < kLongestGap))
      return plain_count(stems.size(), "the numbers in the names leave a gap of " + core::shortest(steps) +
                                           " frames: frames are counted in order of name");
    result.index.push_back(result.index.back() + static_cast<std::int64_t>(steps));
  }
  return result;
}

namespace {

/// What an operating system leaves beside pictures, `._frame1.pgm` among it.
bool is_hidden(const std::filesystem::path& path) {
  return path.filename().string().starts_with('.');
}

PgmSequence list_of(const std::string& directory, std::span<const std::string_view> extensions) {
  std::error_code error;
  PgmSequence sequence;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error))
    if (!is_hidden(entry.path()) &&
        std::find(extensions.begin(), extensions.end(), extension_of(entry.path())) != extensions.end())
      sequence.paths.push_back(entry.path().string());
  if (error) throw core::InputError(directory + ": cannot be read, expected a directory of .pgm files");
  if (sequence.paths.empty()) throw core::InputError(directory + ": holds no .pgm file");
  std::sort(sequence.paths.begin(), sequence.paths.end(), natural_less);
  std::vector<std::string> stems;
  for (const std::string& path : sequence.paths) stems.push_back(std::filesystem::path(path).stem().string());
  FrameNumbers numbers = frame_numbers(stems);
  sequence.index = std::move(numbers.index);
  sequence.note = std::move(numbers.note);
  return sequence;
}

}  // namespace

PgmSequence list_pgm(const std::string& directory) {
  return list_of(directory, kGrey);
}

PgmSequence list_pictures(const std::string& directory) {
  return list_of(directory, kPictures);
}

}  // namespace lookout::tools
