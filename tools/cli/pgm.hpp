#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/grey_image.hpp"

namespace lookout::tools {

using core::GreyImage;
using core::read_pgm;
using core::read_picture;
using core::write_pgm;

/// The .pgm files of a directory (.PGM too) in natural order of their names, frame2 before frame10, and when
/// each was taken.
struct PgmSequence {
  std::vector<std::string> paths;
  std::vector<std::int64_t> index;  ///< Frame numbers from 0 on; gaps in numbered names are kept.
  std::string note;                 ///< What should be told of the numbers; empty for nothing.
};

/// Whether name `a` stands before `b`: runs of digits compare as numbers, all else letter by letter.
bool natural_less(std::string_view a, std::string_view b);

/// @throws core::InputError where there is no such directory or no .pgm file in it.
PgmSequence list_pgm(const std::string& directory);
/// The same of the .pgm and .ppm files, grey or in colours.
PgmSequence list_pictures(const std::string& directory);

/// Frame numbers of names in their order.
struct FrameNumbers {
  std::vector<std::int64_t> index;  ///< From 0 on.
  std::string note;                 ///< Why they are merely counted, where names have numbers; else empty.
};

/// From the last number in each stem (a count, or a time of any digits, 0.50 as well as 1700000000123456),
/// counted from the first in units of the usual difference. Where names are taken at times, an odd hundredth
/// of the unit more or less is no gap. Counted 0, 1, 2, ... where stems have no number, or repeat or reverse
/// it.
FrameNumbers frame_numbers(std::span<const std::string> stems);

}  // namespace lookout::tools
