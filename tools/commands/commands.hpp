#pragma once

#include <string>
#include <vector>

#include "tools/cli/options.hpp"

/// One function a command, each in a file of its own. They return the exit status, throw core::InputError on
/// bad input (status 2), and write data to files and stdout, messages to stderr.
namespace lookout::tools {

int run_command(const Options& options);
int sim_command(const Options& options);
int track_command(const Options& options);
int fuse_command(const Options& options);
int score_command(const Options& options);
int replay_command(const Options& options);
int ospa_command(const Options& options);
int tbd_command(const Options& options);
int detect_command(const Options& options);
int experiment_command(const Options& options);
int compare_command(const Options& options);
int tune_command(const Options& options);
int merge_command(const Options& options);
int initiate_command(const Options& options);
int import_command(const Options& options);
int watch_command(const Options& options);
int status_command(const Options& options);
int plot_command(const Options& options);
int fault_command(const Options& options);
int doctor_command(const Options& options);

/// Names of the formats that `import_command` takes.
std::vector<std::string> import_formats();

}  // namespace lookout::tools
