// lookout import: vendor files -> recording.
#include <array>

#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"
#include "tools/import/import_autoferry.hpp"
#include "tools/import/import_oculus.hpp"
#include "tools/import/import_pgm.hpp"

namespace lookout::tools {
namespace {

/// Lines of one kind that are shown; of more, how many more there are.
constexpr std::size_t kMostShown = 20;

/// Packet streams of one sonar, in order.
ImportSummary oculus(const Options& options) {
  return import_oculus(options.inputs, options.out);
}

ImportSummary pgm(const Options& options) {
  if (options.inputs.size() > 2)
    throw core::InputError("import pgm: expected FOLDER [GEOMETRY.yaml], got " +
                           std::to_string(options.inputs.size()) + " files");
  return import_pgm(options.inputs[0], options.inputs.size() == 2 ? options.inputs[1] : "", options.out);
}

ImportSummary autoferry(const Options& options) {
  if (options.inputs.size() != 2)
    throw core::InputError("import autoferry: expected DETECTIONS.json GROUND_TRUTH.json, got " +
                           std::to_string(options.inputs.size()) + " files");
  return import_autoferry(options.inputs[0], options.inputs[1], options.out);
}

struct Format {
  std::string_view name;
  ImportSummary (*import)(const Options& options);
};
constexpr std::array kFormats{Format{"oculus", oculus}, Format{"pgm", pgm}, Format{"autoferry", autoferry}};

const Format& format_of(const std::string& name) {
  std::string names;
  for (const Format& format : kFormats) {
    if (format.name == name) return format;
    names.append(" ").append(format.name);
  }
  throw core::InputError("FORMAT: got `" + name + "`, expected one of:" + names);
}

void tell(const std::vector<std::string>& lines, const std::string& before) {
  for (std::size_t i = 0; i < std::min(lines.size(), kMostShown); ++i) log_warning(before + lines[i]);
  if (lines.size() > kMostShown)
    log_warning(before + std::to_string(lines.size() - kMostShown) + " more like these");
}

}  // namespace

std::vector<std::string> import_formats() {
  std::vector<std::string> names;
  for (const Format& format : kFormats) names.emplace_back(format.name);
  return names;
}

int import_command(const Options& options) {
  const Format& format = format_of(options.method);
  if (options.inputs.empty()) throw core::InputError("FILE: is missing, expected a file to import");
  if (options.out.empty()) throw core::InputError("--out: is missing, expected a directory to write");
  const ImportSummary summary = format.import(options);
  tell(summary.left_out, "left out: ");
  tell(summary.notes, "");
  log_info(options.out + ": " + summary.imported);
  return 0;
}

}  // namespace lookout::tools
