#pragma once

#include <string>
#include <string_view>

/// Files of text, read and written whole.
namespace lookout::core {

/// The text of a file as UTF-8, without a byte order mark.
/// @param expected what the file should be, for the message: "a YAML file".
/// @throws InputError naming the file: not readable, a directory, above 2 GB, a pipe that nobody
/// writes into, UTF-16 or other binary content.
std::string read_text_file(const std::string& path, std::string_view expected);

/// How a value from a file is shown in a message of one line: in quotes, its first 60 bytes, with a question
/// mark for each that is no printable ASCII. A damaged file can hold anything.
std::string shown(std::string_view value);

/// Writes `text` to a file that takes its name only when all of it is on the disk.
/// @throws InputError where `path` is not a plain file or cannot be created; std::runtime_error where the
/// disk refuses.
void write_text_file(const std::string& path, std::string_view text);

/// @throws InputError where `path` exists and is no plain file: a device or a directory is not to be
/// replaced.
void require_plain_target(const std::string& path);

}  // namespace lookout::core
