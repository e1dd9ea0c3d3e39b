#include "tools/experiments/harness/study.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

using nlohmann::ordered_json;

constexpr std::uint64_t kFnvBasis = 14695981039346656037U;
constexpr std::uint64_t kFnvPrime = 1099511628211U;
constexpr std::size_t kBlock = 65536;

/// As a shell would take it for one word.
std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_of(" \t'\"$*?;&|<>()") == std::string::npos;
  return plain ? word : "'" + word + "'";
}

}  // namespace

std::string command_of(const std::vector<std::string>& words) {
  std::string command = "lookout";
  for (const auto& word : words) command.append(" ").append(quoted(word));
  return command;
}

std::string to_line(const Study& study, const Shard& shard) {
  return ordered_json{{"study", study.name},    {"seed", study.seed},    {"runs", study.runs},
                      {"commit", study.commit}, {"shard", shard.text()}, {"command", study.command},
                      {"words", study.words},   {"inputs", study.inputs}}
      .dump();
}

StudyPart part_of(const std::string& line, const std::string& name) {
  try {
    const ordered_json root = ordered_json::parse(line);
    StudyPart part;
    root.at("study").get_to(part.study.name);
    root.at("seed").get_to(part.study.seed);
    root.at("runs").get_to(part.study.runs);
    root.at("commit").get_to(part.study.commit);
    root.at("command").get_to(part.study.command);
    root.at("words").get_to(part.study.words);
    root.at("inputs").get_to(part.study.inputs);
    part.shard = parse_shard(root.at("shard").get<std::string>());
    return part;
  } catch (const nlohmann::json::exception&) {
    throw core::InputError(name +
                           ":1: is no log of runs of this release, expected one line that says of what");
  }
}

std::string digest_of(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    throw core::InputError(path + ": is no plain file; a study reads its inputs again, expected one");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw core::InputError(path + ": cannot be read");
  std::uint64_t hash = kFnvBasis;
  std::array<char, kBlock> block{};
  do {
    file.read(block.data(), block.size());
    for (std::streamsize i = 0; i < file.gcount(); ++i)
      hash = (hash ^ static_cast<unsigned char>(block[static_cast<std::size_t>(i)])) * kFnvPrime;
  } while (file);
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace lookout::tools
