#pragma once

#include <span>
#include <string>
#include <vector>

namespace lookout::core {

/// A grey image as read from a file.
struct GreyImage {
  int columns = 0;             ///< Pixels of a row, > 0.
  int rows = 0;                ///< Pixels of a column, > 0.
  std::vector<double> pixels;  ///< columns * rows grey levels, row by row.
};

/// Reads a portable grey map: binary (P5) of 8 or 16 bits, the latter most significant byte first, or plain
/// (P2), of at most SonarLimits::kMaxPixels.
/// @throws InputError naming the file and what is wrong: not a PGM, a bad size, truncated.
GreyImage read_pgm(const std::string& path);

/// The same, and portable pixel maps too (P6 and P3), whose colours become grey by grey_level().
/// @throws InputError likewise.
GreyImage read_picture(const std::string& path);

/// Grey level of a colour. [Pakfiliz2018] Eq. (1)
double grey_level(double red, double green, double blue);

/// Writes 16-bit binary. Values are rounded and clamped to 0 .. 65535.
/// @param white the value that a viewer shows as white, from 256 to 65535; larger ones are clamped to it.
/// @throws InputError where nothing can be written there, std::runtime_error where the disk is full; then
/// nothing half-written is left.
void write_pgm(const std::string& path, const GreyImage& image, int white = 65535);

}  // namespace lookout::core
