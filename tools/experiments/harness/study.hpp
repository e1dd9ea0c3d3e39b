#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/experiments/harness/shard.hpp"

namespace lookout::tools {

/// What fixes the results of a study, wherever and in however many parts it is run.
struct Study {
  std::string name;        ///< An experiment's name, or "compare".
  std::string command;     ///< Without what changes no result: see `command_of`.
  std::uint64_t seed = 1;  ///< Of all draws.
  int runs = 0;            ///< Asked for, of each cell.
  std::string commit;      ///< Of the program.
  std::map<std::string, std::vector<std::string>> words;  ///< What the study is made of, by kind.
  std::map<std::string, std::string> inputs;              ///< Digest of each file that it reads, by path.

  bool operator==(const Study&) const = default;
};

/// `lookout WORDS` as one would type it, without --out, --jobs, --resume and --shard. Words with blanks are
/// quoted.
std::string command_of(const std::vector<std::string>& words);

/// A study and which part of it, as one line of JSON, and back.
std::string to_line(const Study& study, const Shard& shard);

/// What `to_line` wrote.
struct StudyPart {
  Study study;
  Shard shard;
};
/// @param name of the file, for the message. @throws core::InputError on a line of another shape.
StudyPart part_of(const std::string& line, const std::string& name);

/// 16 hexadecimal digits that change with the file's content (FNV-1a).
/// @throws core::InputError where it cannot be read.
std::string digest_of(const std::string& path);

}  // namespace lookout::tools
