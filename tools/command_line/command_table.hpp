#pragma once

#include <span>

namespace CLI {
class App;
}

namespace lookout::tools {

struct Options;

/// One word behind `lookout`.
struct Command {
  const char* name;                                  ///< The word.
  const char* summary;                               ///< For the help, a sentence.
  const char* example;                               ///< For the help, a whole line.
  void (*declare)(CLI::App& app, Options& options);  ///< Adds its flags.
  int (*run)(const Options& options);                ///< Returns the exit status.
};

/// All of them, in the order of the help.
std::span<const Command> commands();

}  // namespace lookout::tools
