#include "core/files/grey_image.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/files/text_file.hpp"
#include "core/input_error.hpp"
#include "core/sonar_limits.hpp"

namespace lookout::core {
namespace {

constexpr int kLargestSide = 1 << 15;
constexpr int kLargestValue = 65535;
constexpr std::size_t kColours = 3;
constexpr double kRed = 0.2989, kGreen = 0.587, kBlue = 0.114;  // [Pakfiliz2018] Eq. (1)
constexpr std::size_t kMostPixels = SonarLimits::kMaxPixels;

/// Reads a PGM held in memory, or a PPM.
class PgmReader {
 public:
  PgmReader(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

  GreyImage read_grey() {
    const std::string magic = bytes_.substr(0, 2);
    if (magic != "P5" && magic != "P2") fail("is not a PGM file, expected one that begins with P5 or P2");
    return read(magic == "P5", 1);
  }

  GreyImage read_any() {
    const std::string magic = bytes_.substr(0, 2);
    if (magic != "P6" && magic != "P3" && magic != "P5" && magic != "P2")
      fail("is no PGM or PPM file, expected one that begins with P5, P2, P6 or P3");
    const bool colour = magic == "P6" || magic == "P3";
    GreyImage image = read(magic == "P6" || magic == "P5", colour ? kColours : 1);
    if (colour) to_grey(image.pixels);
    return image;
  }

 private:
  /// @param values a pixel. The image then has as many values a pixel.
  GreyImage read(bool binary, std::size_t values) {
    at_ = 2;
    GreyImage image;
    image.columns = number("width", 1, kLargestSide);
    image.rows = number("height", 1, kLargestSide);
    largest_ = number("maximum value", 1, kLargestValue);
    const auto size = static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
    if (size > kMostPixels)
      fail("has " + std::to_string(size) + " pixels, expected at most " + std::to_string(kMostPixels));
    values_ = values;
    binary ? read_binary(size * values, image) : read_plain(size * values, image);
    return image;
  }

  static void to_grey(std::vector<double>& values) {
    const std::size_t size = values.size() / kColours;
    for (std::size_t i = 0; i < size; ++i)
      values[i] = grey_level(values[kColours * i], values[kColours * i + 1], values[kColours * i + 2]);
    values.resize(size);
  }

  [[noreturn]] void fail(const std::string& message) const { throw InputError(path_ + ": " + message); }

  [[noreturn]] void fail_short(std::size_t held, std::size_t expected) const {
    fail("is truncated: holds " + std::to_string(held / values_) + " of " +
         std::to_string(expected / values_) + " pixels");
  }

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

  /// One white space ends the header. Of a header in lines of CR LF that is two bytes, which only the size
  /// of the file tells from a first pixel of 10.
  void skip_end_of_header(std::size_t bytes_of_pixels) {
    const bool is_crlf = bytes_.compare(at_, 2, "\r\n") == 0 && bytes_.size() - at_ == bytes_of_pixels + 2;
    at_ += is_crlf ? 2 : 1;
  }

  void read_binary(std::size_t size, GreyImage& image) {
    const std::size_t width = largest_ > 255 ? 2 : 1;
    skip_end_of_header(size * width);
    const std::size_t held = bytes_.size() > at_ ? (bytes_.size() - at_) / width : 0;
    if (held < size) fail_short(held, size);
    image.pixels.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      const auto byte = [&](std::size_t k) {
        return static_cast<unsigned char>(bytes_[at_ + i * width + k]);
      };
      image.pixels[i] = width == 2 ? byte(0) * 256.0 + byte(1) : byte(0);
    }
  }

  void read_plain(std::size_t size, GreyImage& image) {
    for (std::size_t i = 0; i < size; ++i) {
      skip_space_and_comments();
      if (at_ >= bytes_.size()) fail_short(i, size);
      image.pixels.push_back(number("pixel", 0, largest_));
    }
  }

  const std::string& path_;
  const std::string& bytes_;
  std::size_t at_ = 0;
  std::size_t values_ = 1;  ///< A pixel.
  int largest_ = 0;
};

std::string bytes_of(const std::string& path) {
  std::error_code ignored;
  const bool is_plain = std::filesystem::is_regular_file(path, ignored);  // To open a pipe is to wait for it.
  std::ifstream file;
  if (is_plain) file.open(path, std::ios::binary);
  if (!file.is_open()) throw InputError(path + ": cannot be read, expected a plain file");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

GreyImage read_pgm(const std::string& path) {
  const std::string bytes = bytes_of(path);
  return PgmReader(path, bytes).read_grey();
}

GreyImage read_picture(const std::string& path) {
  const std::string bytes = bytes_of(path);
  return PgmReader(path, bytes).read_any();
}

double grey_level(double red, double green, double blue) {
  return kRed * red + kGreen * green + kBlue * blue;
}

void write_pgm(const std::string& path, const GreyImage& image, int white) {
  std::string bytes = "P5\n" + std::to_string(image.columns) + " " + std::to_string(image.rows) + "\n" +
                      std::to_string(white) + "\n";
  bytes.reserve(bytes.size() + 2 * image.pixels.size());
  for (const double pixel : image.pixels) {
    const int value = static_cast<int>(std::lround(std::clamp(pixel, 0.0, static_cast<double>(white))));
    bytes += static_cast<char>(value >> 8);
    bytes += static_cast<char>(value & 255);
  }
  write_text_file(path, bytes);
}

}  // namespace lookout::core
