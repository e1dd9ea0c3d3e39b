#include "tools/cli/paths.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "core/input_error.hpp"
#include "tools/cli/log.hpp"

extern char** environ;

namespace lookout::tools {
namespace {

constexpr int kRefused = 2;  // Exit status of a script that has told what is wrong with its input.

}  // namespace

std::string tools_directory() {
  if (const char* given = std::getenv("LOOKOUT_TOOLS")) return given;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto installed = program.parent_path().parent_path() / "share/lookout/tools";
  if (!error && std::filesystem::is_directory(installed)) return installed.string();
  return LOOKOUT_TOOLS_DIR;
}

void make_directory(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw core::InputError(path + ": cannot be created: " + error.message());
}

int run_plot_script(const std::string& script, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"/usr/bin/python3", tools_directory() + "/" + script};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  int status = -1;
  if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) == 0) waitpid(child, &status, 0);
  if (status == 0) return 0;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kRefused) return kRefused;
  log_warning(script + " made no plots (python3-matplotlib draws them)");
  return 1;
}

}  // namespace lookout::tools
