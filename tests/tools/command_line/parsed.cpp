#include "tests/tools/command_line/parsed.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace lookout::tools {

Options parsed(void (*declare)(CLI::App& app, Options& options), const std::string& words) {
  Options options;
  CLI::App app;
  declare(app, options);
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  return options;
}

std::string help_of(void (*declare)(CLI::App& app, Options& options)) {
  Options options;
  CLI::App app;
  declare(app, options);
  return app.help();
}

}  // namespace lookout::tools
