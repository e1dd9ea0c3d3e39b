// The program: which command is meant, and its exit status. Commands and their flags: tools/command_line.
#include <CLI/CLI.hpp>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/input_error.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/version.hpp"
#include "tools/command_line/command_table.hpp"

namespace lookout::tools {
namespace {

constexpr int kFailure = 1;
constexpr int kBadInput = 2;

/// The release, and the commit where it is known.
std::string version_line() {
  const std::string commit = version();
  return "lookout " + release() + (commit == "release " + release() ? "" : " (commit " + commit + ")");
}

/// One line for a person; the status for a script.
int report(const std::string& message, int status) {
  std::cerr << "lookout: " << message << "\n";
  return status;
}

/// The status, where all that was said got out.
int flushed(int status) {
  std::cout.flush();
  return std::cout ? status : report("standard output: could not be written", kFailure);
}

/// A flag's text that is no number, where the library says `Could not convert: --order = abc`.
std::string not_a_number(std::string message) {
  constexpr std::string_view kBegin = "Could not convert: ", kBetween = " = ";
  const std::size_t between = message.find(kBetween);
  if (!message.starts_with(kBegin) || between == std::string::npos) return message;
  const std::string flag = message.substr(kBegin.size(), between - kBegin.size());
  return flag + ": got `" + message.substr(between + kBetween.size()) + "`, expected a number";
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Lookout: what moves around an underwater vehicle, from the returns of its sonar.", "lookout");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_line);
  const Command* chosen = nullptr;
  for (const auto& command : commands()) {
    auto* sub = app.add_subcommand(command.name, command.summary);
    sub->description(std::string("Example:\n  ") + command.example + "\n\n" + command.summary);
    command.declare(*sub, options);
    sub->callback([&chosen, &command] { chosen = &command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // For help, or the version.
    return flushed(app.exit(asked));
  } catch (const CLI::ConversionError& error) {
    return report(not_a_number(error.what()), kBadInput);
  } catch (const CLI::ParseError& error) {
    return report(error.what(), kBadInput);
  }
  return flushed(chosen->run(options));
}

}  // namespace
}  // namespace lookout::tools

int main(int argc, char** argv) {
  using namespace lookout::tools;
  try {
    return run(argc, argv);
  } catch (const lookout::core::InputError& error) {
    return report(error.what(), kBadInput);
  } catch (const std::invalid_argument& error) {  // A parameter that the library refuses, by name and value.
    return report(error.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return report("out of memory", kFailure);
  } catch (const std::exception& error) {
    return report(error.what(), kFailure);
  }
}
