#include "tools/cli/pgm.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

constexpr int kLargestSide = 1 << 15;
constexpr int kLargestValue = 65535;
constexpr std::size_t kMostDigits = 15;  // of a frame number, so that it fits 64 bits

/// Reads a PGM held in memory.
class PgmReader {
 public:
  PgmReader(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

  GreyImage read() {
    const std::string magic = bytes_.substr(0, 2);
    if (magic != "P5" && magic != "P2") fail("is not a PGM file, expected one that begins with P5 or P2");
    at_ = 2;
    GreyImage image;
    image.columns = number("width", 1, kLargestSide);
    image.rows = number("height", 1, kLargestSide);
    largest_ = number("maximum value", 1, kLargestValue);
    const auto size = static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
    magic == "P5" ? read_binary(size, image) : read_plain(size, image);
    return image;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw core::InputError(path_ + ": " + message); }

  void skip_space_and_comments() {
    while (at_ < bytes_.size() &&
           (std::isspace(static_cast<unsigned char>(bytes_[at_])) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#')
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      else
        ++at_;
    }
  }

  int number(const char* what, int least, int most) {
    skip_space_and_comments();
    long value = -1;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) &&
           value <= kLargestValue)
      value = std::max(0L, value) * 10 + (bytes_[at_++] - '0');
    if (value < least || value > most)
      fail(std::string("has a bad ") + what + ", expected a number of " + std::to_string(least) + " to " +
           std::to_string(most));
    return static_cast<int>(value);
  }

  void read_binary(std::size_t size, GreyImage& image) {
    ++at_;  // one white space ends the header
    const std::size_t width = largest_ > 255 ? 2 : 1;
    const std::size_t held = bytes_.size() > at_ ? (bytes_.size() - at_) / width : 0;
    if (held < size)
      fail("is truncated: holds " + std::to_string(held) + " of " + std::to_string(size) + " pixels");
    for (std::size_t i = 0; i < size; ++i) {
      const auto byte = [&](std::size_t k) {
        return static_cast<unsigned char>(bytes_[at_ + i * width + k]);
      };
      image.pixels.push_back(width == 2 ? byte(0) * 256.0 + byte(1) : byte(0));
    }
  }

  void read_plain(std::size_t size, GreyImage& image) {
    for (std::size_t i = 0; i < size; ++i) {
      skip_space_and_comments();
      if (at_ >= bytes_.size())
        fail("is truncated: holds " + std::to_string(i) + " of " + std::to_string(size) + " pixels");
      image.pixels.push_back(number("pixel", 0, largest_));
    }
  }

  const std::string& path_;
  const std::string& bytes_;
  std::size_t at_ = 0;
  int largest_ = 0;
};

/// The digits at the end of a stem, or -1.
std::int64_t trailing_number(const std::string& stem) {
  std::size_t first = stem.size();
  while (first > 0 && std::isdigit(static_cast<unsigned char>(stem[first - 1]))) --first;
  if (first == stem.size() || stem.size() - first > kMostDigits) return -1;
  return std::stoll(stem.substr(first));
}

std::vector<std::int64_t> plain_count(std::size_t size) {
  std::vector<std::int64_t> numbers(size);
  for (std::size_t i = 0; i < size; ++i) numbers[i] = static_cast<std::int64_t>(i);
  return numbers;
}

}  // namespace

GreyImage read_pgm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw core::InputError(path + ": cannot be read");
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return PgmReader(path, bytes).read();
}

void write_pgm(const std::string& path, const GreyImage& image) {
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << image.columns << " " << image.rows << "\n" << kLargestValue << "\n";
  for (const double pixel : image.pixels) {
    const int value = static_cast<int>(std::lround(std::clamp(pixel, 0.0, double{kLargestValue})));
    file.put(static_cast<char>(value >> 8)).put(static_cast<char>(value & 255));
  }
  if (!file.flush()) throw core::InputError(path + ": cannot be written");
}

std::vector<std::int64_t> frame_numbers(std::span<const std::string> stems) {
  std::vector<std::int64_t> numbers;
  std::int64_t step = std::numeric_limits<std::int64_t>::max();
  for (const std::string& stem : stems) {
    numbers.push_back(trailing_number(stem));
    if (numbers.back() < 0) return plain_count(stems.size());
    if (numbers.size() < 2) continue;
    const std::int64_t difference = numbers.back() - numbers[numbers.size() - 2];
    if (difference <= 0) return plain_count(stems.size());
    step = std::min(step, difference);
  }
  const std::int64_t first = numbers.empty() ? 0 : numbers.front();
  for (std::int64_t& number : numbers) {
    if ((number - first) % step != 0) return plain_count(stems.size());
    number = (number - first) / step;
  }
  return numbers;
}

PgmSequence list_pgm(const std::string& directory) {
  std::error_code error;
  PgmSequence sequence;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error))
    if (entry.path().extension() == ".pgm") sequence.paths.push_back(entry.path().string());
  if (error) throw core::InputError(directory + ": cannot be read, expected a directory of .pgm files");
  if (sequence.paths.empty()) throw core::InputError(directory + ": holds no .pgm file");
  std::sort(sequence.paths.begin(), sequence.paths.end());
  std::vector<std::string> stems;
  for (const std::string& path : sequence.paths) stems.push_back(std::filesystem::path(path).stem().string());
  sequence.index = frame_numbers(stems);
  return sequence;
}

}  // namespace lookout::tools
