#include "tools/experiments/harness/keyed_log.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/input_error.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/version.hpp"

namespace lookout::tools {
namespace {

using nlohmann::json;

constexpr const char* kEndLine = "{\"end\":true}";
constexpr const char* kUnfinished = ".part";  // Behind the name of a log that is being copied.

/// Whether what one log holds is of use to another: runs and the choice of cells are free.
bool serves(const Study& old, const Study& now) {
  const auto essence = [](Study study) {
    study.runs = 0;
    study.command.clear();
    study.words.erase("only");
    return study;
  };
  return essence(old) == essence(now);
}

StudyPart part_in(std::istream& file, const std::string& path) {
  std::string line;
  if (!std::getline(file, line))
    throw core::InputError(path + ": cannot be read, expected the log of a study");
  return part_of(line, path);
}

/// What is the matter with a part of another study, in one word or two.
std::string difference(const Study& a, const Study& b) {
  if (a.seed != b.seed) return "seed";
  if (a.commit != b.commit) return "commit";
  if (a.command != b.command) return "command";
  return "content of its input files";
}

bool has_ended(std::istream& file) {
  std::string line;
  bool ended = false;
  while (std::getline(file, line)) ended = line == kEndLine;
  return ended;
}

/// One directory with a part of a study.
struct PartDirectory {
  std::string path;
  StudyPart part;
};

PartDirectory open_part(const std::string& directory) {
  const std::string path = directory + kLogName;
  std::ifstream file(path);
  return {directory, part_in(file, path)};
}

void require_one_study(const PartDirectory& first, const PartDirectory& other) {
  const auto refuse = [&](const std::string& what) {
    throw core::InputError("merge: " + other.path + ": is of another " + what + " than " + first.path +
                           ", expected shards of one study");
  };
  if (other.part.study != first.part.study) refuse(difference(first.part.study, other.part.study));
  if (other.part.shard.count != first.part.shard.count) refuse("number of shards");
}

std::map<int, PartDirectory> parts_in(const std::vector<std::string>& directories) {
  if (directories.empty()) throw core::InputError("merge: expected the directories of the shards");
  std::map<int, PartDirectory> parts;
  const PartDirectory first = open_part(directories.front());
  for (const auto& directory : directories) {
    PartDirectory next = open_part(directory);
    require_one_study(first, next);
    const auto [place, is_new] = parts.emplace(next.part.shard.index, next);
    if (!is_new)
      throw core::InputError("merge: " + directory + ": holds shard " + next.part.shard.text() +
                             ", and so does " + place->second.path);
  }
  return parts;
}

void require_all(const std::map<int, PartDirectory>& parts) {
  const int count = parts.begin()->second.part.shard.count;
  std::string missing;
  for (int index = 1; index <= count; ++index)
    if (!parts.contains(index)) missing.append(missing.empty() ? "" : " ").append(std::to_string(index));
  if (!missing.empty())
    throw core::InputError("merge: of " + std::to_string(count) + " shards these are missing: " + missing);
}

void require_ended(const PartDirectory& part) {
  std::ifstream file(part.path + kLogName);
  if (!has_ended(file))
    throw core::InputError("merge: " + part.path + ": shard " + part.part.shard.text() +
                           " is not finished; run it again with --resume");
}

void append_tasks(const PartDirectory& part, KeyedLog& log) {
  std::ifstream file(part.path + kLogName);
  std::string line;
  while (std::getline(file, line))
    if (const auto key = key_of_line(line)) log.append(*key, line);
}

}  // namespace

std::optional<std::string> key_of_line(const std::string& line) {
  const json entry = json::parse(line, nullptr, false);
  if (!entry.is_object() || !entry.contains("key") || !entry["key"].is_string()) return std::nullopt;
  return entry["key"].get<std::string>();
}

KeyedLog::KeyedLog(const std::string& path, const Study& study, const Shard& shard, bool resume)
    : path_(path) {
  const bool goes_on = resume && std::filesystem::exists(path);
  const std::string written = goes_on ? path + kUnfinished : path;
  file_.open(written, std::ios::binary);
  if (!file_) throw core::InputError(path + ": cannot be written");
  write(to_line(study, shard));
  if (!goes_on) return;
  try {
    copy_from(path, {study, shard});
  } catch (...) {
    file_.close();
    std::filesystem::remove(written);
    throw;
  }
  std::filesystem::rename(written, path);
}

// Written again rather than appended to: the last line of an interrupted file may be half a line.
void KeyedLog::copy_from(const std::string& old_path, const StudyPart& part) {
  std::ifstream old(old_path, std::ios::binary);
  const StudyPart before = part_in(old, old_path);
  if (!serves(before.study, part.study) || before.shard.text() != part.shard.text())
    throw core::InputError(old_path + ":1: belongs to another study, seed, commit, input or shard; " +
                           "--resume needs the same");
  std::string line;
  while (std::getline(old, line))
    if (const auto key = key_of_line(line); key && !has(*key)) append(*key, line);
}

std::optional<std::string> KeyedLog::find(const std::string& key) const {
  const auto place = places_.find(key);
  if (place == places_.end()) return std::nullopt;
  std::ifstream file(path_, std::ios::binary);
  file.seekg(place->second);
  std::string line;
  std::getline(file, line);
  return line;
}

void KeyedLog::append(const std::string& key, const std::string& line) {
  places_.insert_or_assign(key, static_cast<std::streamoff>(file_.tellp()));
  write(line);
}

void KeyedLog::end() {
  write(kEndLine);
}

void KeyedLog::write(const std::string& line) {
  file_ << line << std::endl;
  if (!file_) throw std::runtime_error(path_ + ": could not be written: is the disk full?");
}

Study merge_logs(const std::vector<std::string>& directories, const std::string& out) {
  const auto parts = parts_in(directories);
  require_all(parts);
  for (const auto& [index, part] : parts) require_ended(part);
  const Study& study = parts.begin()->second.part.study;
  if (study.commit != version())
    throw core::InputError("merge: the shards are of commit " + study.commit + ", this program is " +
                           version() + "; expected the program that made them");
  for (const auto& directory : directories) {
    std::error_code unknown;
    if (std::filesystem::equivalent(directory, out, unknown))
      throw core::InputError("--out: " + out + " is a shard, expected a directory of its own");
  }
  make_directory(out);
  KeyedLog log(out + kLogName, study, {}, false);
  for (const auto& [index, part] : parts) append_tasks(part, log);
  log.end();
  return study;
}

}  // namespace lookout::tools
