#include "tools/command_line/command_table.hpp"

#include "tools/command_line/command_flags.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

constexpr Command kCommands[] = {
    {"run", "Runs a scene through the whole chain in one process, as fast as it computes.",
     "lookout run tools/scenarios/tracking_table7.yaml --out out/run", declare_run, run_command},
    {"sim", "Publishes a scene's vehicle states, scans and truth over LCM.",
     "lookout sim tools/scenarios/tracking_table7.yaml --wait-for 1", declare_sim, sim_command},
    {"track", "The on-vehicle process: scans in, tracks out, over LCM.", "lookout track --node-id 1",
     declare_track, track_command},
    {"fuse", "Joins the estimates of several vehicles: LOCAL_ESTIMATE in, GLOBAL_TRACKS out, over LCM.",
     "lookout fuse --method learned", declare_fuse, fuse_command},
    {"score", "Scores TRACKS against GROUND_TRUTH live over LCM; prints the mean at its end.",
     "lookout score --truth visible", declare_score, score_command},
    {"replay", "Tracks a recording or an LCM log again, the same tracks every time.",
     "lookout replay out/demo/demo.lcmlog --out out/replay", declare_replay, replay_command},
    {"ospa", "Scores estimated positions against the truth, offline.",
     "lookout ospa out/run/truth.csv out/run/tracks.csv --cutoff 20", declare_ospa, ospa_command},
    {"tbd", "Tracks targets in the raw intensities of an image sequence.",
     "lookout tbd i_h_pmht_4 tools/data/tbd_example --config tools/data/tbd_example/config.yaml --out "
     "tracks.csv",
     declare_tbd, tbd_command},
    {"detect", "Finds returns in sonar images, one an echo, at a stated false-alarm rate: live or recorded.",
     "lookout detect out/images --out out/returns", declare_detect, detect_command},
    {"initiate", "Starts tracks on recorded points with one initiator.",
     "lookout initiate vct points.csv --out tracks.csv --config radar.yaml", declare_initiate,
     initiate_command},
    {"import", "Makes a recording of a vendor's files.", "lookout import oculus dive.raw --out out/dive",
     declare_import, import_command},
    {"experiment", "Runs a paper's experiment, Monte Carlo, and sets our figures beside the paper's.",
     "lookout experiment csht-window --runs 20 --only p_miss=0.1 --out out/window", declare_experiment,
     experiment_command},
    {"compare", "Runs trackers on scenes of your own with common seeds: curves, tests, tables, a report.",
     "lookout compare tools/scenarios/crossing.yaml --method joint --method gnn --runs 50 --out out/compare",
     declare_compare, compare_command},
    {"tune", "Sweeps one parameter of a tracker over a scene with common seeds, and plots what it does.",
     "lookout tune tools/scenarios/crossing.yaml --parameter joint.birth.begin_nats=8:14 --runs 20 --out "
     "out/tune",
     declare_tune, tune_command},
    {"merge",
     "Joins the shards of an experiment or a comparison into one result, as if one machine had done all.",
     "lookout merge shards/* --out out/window", declare_merge, merge_command},
    {"watch", "Shows what the sonar hears and the tracker believes, live or out of a log, in a browser.",
     "lookout watch --http 8080", declare_watch, watch_command},
    {"status", "Shows in a terminal whether the chain is healthy, and why not.", "lookout status --once",
     declare_status, status_command},
    {"plot", "Draws a run, a replay, a log or anyone's recording.", "lookout plot out/run", declare_plot,
     plot_command},
    {"fault", "Relays traffic from one channel prefix to another and spoils it by plan and seed.",
     "lookout fault tools/scenarios/faults/scan_lost.yaml --to-prefix FAULTY_", declare_fault, fault_command},
    {"doctor", "Checks this computer and its link, and says what to type; exit 1 where something would fail.",
     "lookout doctor --channel-prefix AUV1_", declare_doctor, doctor_command},
};

}  // namespace

std::span<const Command> commands() {
  return kCommands;
}

}  // namespace lookout::tools
