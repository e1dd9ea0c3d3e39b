#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

/// What the targets share. A target is one file with libFuzzer's entry; the kept corpus goes through the same
/// entry in every run of the tests (replay.cpp).
namespace lookout::tests {

/// Ends the process where a promise is broken, so that a fuzzer sees it.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// What a fuzzer gives, as text; valid as long as its bytes.
inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Calls `read`. It may refuse, in one line of bounded length, and throw nothing else.
template <class Read>
void read_or_refuse(Read read) {
  constexpr std::size_t kLongestLine = 2000;
  try {
    read();
  } catch (const core::InputError& error) {
    const std::string_view line = error.what();
    const bool is_one_line =
        !line.empty() && line.size() < kLongestLine && line.find('\n') == std::string_view::npos;
    if (!is_one_line) std::cerr << "refused in other than one line: " << line << "\n";
    require(is_one_line);
  }
}

/// A folder of this process for what is read from files.
inline const TemporaryDirectory& scratch() {
  static const TemporaryDirectory folder;
  return folder;
}

/// Writes bytes as they are to `name` in the folder; its path.
inline std::string write_scratch(const std::string& name, std::string_view bytes) {
  const std::string path = scratch().file(name);
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace lookout::tests
