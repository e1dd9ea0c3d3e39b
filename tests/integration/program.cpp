#include "tests/integration/program.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

ProgramResult run_lookout(const std::string& arguments) {
  const TemporaryDirectory folder;
  std::string command = LOOKOUT_PROGRAM;
  command.append(" ").append(arguments).append(" >").append(folder.file("out"));
  command.append(" 2>").append(folder.file("err"));
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder.file("out")),
          text_of(folder.file("err"))};
}

}  // namespace lookout::tests
