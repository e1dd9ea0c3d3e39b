#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lookout::tools {

/// A grey image as read from a file.
struct GreyImage {
  int columns = 0;
  int rows = 0;
  std::vector<double> pixels;  ///< columns * rows grey levels, row by row.
};

/// Reads a portable grey map: binary (P5) of 8 or 16 bits, the latter most significant byte first, or plain
/// (P2).
/// @throws core::InputError naming the file and what is wrong: not a PGM, a bad size, truncated.
GreyImage read_pgm(const std::string& path);

/// Writes 16-bit binary. Values are rounded and clamped to 0 .. 65535. @throws core::InputError.
void write_pgm(const std::string& path, const GreyImage& image);

/// The .pgm files of a directory, sorted by name, and when each was taken.
struct PgmSequence {
  std::vector<std::string> paths;
  std::vector<std::int64_t> index;  ///< Frame numbers from 0 on; gaps in numbered names are kept.
};

/// @throws core::InputError where there is no such directory or no .pgm file in it.
PgmSequence list_pgm(const std::string& directory);

/// Frame numbers from the digits at the end of each stem, counted from the first in units of the smallest
/// difference; 0, 1, 2, ... where the names are not numbered or not in steps of it.
std::vector<std::int64_t> frame_numbers(std::span<const std::string> stems);

}  // namespace lookout::tools
