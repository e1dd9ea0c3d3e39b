#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lookout::tools {

/// Everything that the command line can say; each command reads its own part. Empty texts were not given.
struct Options {
  std::vector<std::string> inputs;   ///< Scenario, recording, log or CSV files, in the order given.
  std::string method;                ///< Initiator, tbd or fusion method, or the experiment's name.
  std::string out;                   ///< Directory or file to write.
  std::vector<std::string> plugins;  ///< Shared libraries that were loaded, as they were named.
  std::uint64_t seed = 1;
  std::string config;  ///< Configuration YAML.
  /// The configuration itself, which `config` then only names; empty: it is read from there.
  std::string config_text;
  std::string input = "scan";  ///< What is tracked: scan or image.
  std::string estimator;       ///< Registry name; empty: the configuration's, else the default.
  std::string tracker;         ///< Registry name; empty: the configuration's, else the default.
  std::optional<double> lag;   ///< Delayed output [s].
  bool explain = false;
  bool unknown_sensor = false;  ///< `run` keeps the scene's sensor figures from the tracker.
  bool publish_estimates = false;
  std::optional<double> clutter_every;  ///< `track` also publishes CLUTTER_MAP, so often [s].
  int node_id = 1;
  double cutoff = 20.0;                  ///< OSPA cut-off [m].
  double order = 2.0;                    ///< OSPA order.
  std::string metric = "ospa";           ///< Of `ospa`.
  std::string over_time;                 ///< CSV of the metric over time, of `ospa`.
  std::optional<double> time_tolerance;  ///< Times that differ by no more are one [s].
  bool interpolate = false;              ///< The truth between its times.
  std::optional<double> window;          ///< Of ospa2 [s]; none: the whole run.
  std::optional<double> switch_penalty;  ///< Of tgospa [m]; none: a tenth of the cut-off.
  std::string truth = "visible";         ///< visible or schedule.
  std::optional<double> votes_at;        ///< Scenario time of the vote matrices to write [s].
  std::string times;                     ///< CSV of scan times.
  bool json = false;
  std::string tracks_channel;  ///< Channel that `score` listens to.
  std::string lcm_url;
  std::string channel_prefix;
  std::optional<double> duration;   ///< Wall time [s].
  std::optional<double> idle_exit;  ///< Wall time of silence [s].
  int wait_for = 0;
  std::string speed = "1";            ///< Factor over real time, or "max".
  std::optional<double> answer_wait;  ///< At full speed, the longest wait for TRACKS of a scan [s].
  std::int64_t start_utime = 0;       ///< Scenario time of the first scan [us].
  int runs = 100;
  int jobs = 0;  ///< Threads; 0: all cores.
  std::vector<std::string> only;
  bool resume = false;
  std::string shard;                    ///< K/N: this part of the runs; empty: all.
  std::vector<std::string> methods;     ///< Of `compare`, as typed.
  std::vector<std::string> parameters;  ///< Of `tune`: KEY=RANGE.
  /// Values of the tracker's parameters that `tune` tries, over the configuration: NAME.PATH or coast_s.
  std::map<std::string, double> settings;
  bool list = false;
  std::string http = "8080";  ///< PORT or ADDRESS:PORT of `watch`.
  std::string decisions;      ///< File of a tracker's --explain lines, for `watch`.
  bool once = false;          ///< `status` prints once and ends.
  std::string to_url;         ///< LCM transport to which `fault` relays; empty: that it hears.
  std::string to_prefix;      ///< Before the channel names to which `fault` relays.
  std::string state;          ///< File by which `track` goes on after a restart.
  bool animate = false;       ///< `plot` also draws a GIF.
};

}  // namespace lookout::tools
