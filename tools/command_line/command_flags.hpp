#pragma once

namespace CLI {
class App;
}

namespace lookout::tools {

struct Options;

/// The flags of each command: adds them to `app`, which fills `options` when it parses. The commands that go
/// from files to files stand in offline_flags.cpp,
void declare_run(CLI::App& app, Options& options);
void declare_replay(CLI::App& app, Options& options);
void declare_ospa(CLI::App& app, Options& options);
void declare_tbd(CLI::App& app, Options& options);
void declare_initiate(CLI::App& app, Options& options);
void declare_import(CLI::App& app, Options& options);

/// those that speak on a link in live_flags.cpp,
void declare_sim(CLI::App& app, Options& options);
void declare_track(CLI::App& app, Options& options);
void declare_fuse(CLI::App& app, Options& options);
void declare_score(CLI::App& app, Options& options);
void declare_detect(CLI::App& app, Options& options);
void declare_fault(CLI::App& app, Options& options);

/// those that run trackers many times in study_flags.cpp,
void declare_experiment(CLI::App& app, Options& options);
void declare_tune(CLI::App& app, Options& options);
void declare_compare(CLI::App& app, Options& options);
void declare_merge(CLI::App& app, Options& options);

/// and those that look at a chain, a log or this computer in watching_flags.cpp.
void declare_watch(CLI::App& app, Options& options);
void declare_status(CLI::App& app, Options& options);
void declare_plot(CLI::App& app, Options& options);
void declare_doctor(CLI::App& app, Options& options);

}  // namespace lookout::tools
