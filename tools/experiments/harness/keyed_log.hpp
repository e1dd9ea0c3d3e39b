#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/experiments/harness/study.hpp"

namespace lookout::tools {

/// The finished tasks of a study on disk: a line that says of what, one JSON line a task, in whatever order
/// they end, and a last line once all are there. Memory holds the keys alone.
class KeyedLog {
 public:
  /// Begins the file at `path`, or with `resume` goes on with what it holds; half a line at its end and lines
  /// of another shape are tasks to do again.
  /// @throws core::InputError where it cannot be written or belongs to another study, seed, commit, input or
  /// shard. Runs and `only` may differ: what is there already serves.
  KeyedLog(const std::string& path, const Study& study, const Shard& shard, bool resume);

  bool has(const std::string& key) const { return places_.contains(key); }  ///< Whether it is finished.
  /// The line of a finished task; nothing of others.
  std::optional<std::string> find(const std::string& key) const;
  /// @param line a JSON object on one line, whose first member is `key`.
  /// @throws std::runtime_error where the disk refuses.
  void append(const std::string& key, const std::string& line);
  void end();  ///< All tasks are there.

 private:
  void copy_from(const std::string& old_path, const StudyPart& part);
  void write(const std::string& line);

  std::string path_;
  std::ofstream file_;
  std::map<std::string, std::streamoff> places_;  ///< Where the line of a key begins.
};

/// The key of a line of a log; nothing where it is no JSON object with a text "key".
std::optional<std::string> key_of_line(const std::string& line);

/// The name of the log in the directory of a study.
inline constexpr const char* kLogName = "/runs.jsonl";

/// Joins the parts of one study that lie in `directories` into the log of `out`, in the order of the shards.
/// @return the study.
/// @throws core::InputError naming the directories: parts of different studies, seeds, commits, inputs or
/// numbers of shards; a shard that is there twice, missing or unfinished; parts of another commit than this
/// program's; and an `out` that is one of them.
Study merge_logs(const std::vector<std::string>& directories, const std::string& out);

}  // namespace lookout::tools
