#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace lookout::core {

/// How long a pipe is listened to before it is given up.
struct PipePatience {
  std::chrono::milliseconds writer{2'000};    ///< For somebody who writes into it to come.
  std::chrono::milliseconds silence{60'000};  ///< For the next bytes of whoever holds it open.
};

/// All bytes of a file, a pipe or a terminal. A pipe (`<(command)`, /dev/stdin, a named one) is read to its
/// end; one that nobody writes into is refused and not waited for without an end. Reading stops behind the
/// first zero byte, which no text has: a device that never ends is not read for ever.
/// @param expected what the file should be, for the message: "a YAML file".
/// @throws InputError naming the file: not there, not readable, a directory, above 2 GB, a silent pipe.
std::string input_bytes(const std::string& path, std::string_view expected,
                        const PipePatience& patience = {});

}  // namespace lookout::core
