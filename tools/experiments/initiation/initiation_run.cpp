#include "tools/experiments/initiation/initiation_run.hpp"

#include <ctime>
#include <stdexcept>

#include "core/files/csv.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/initiation/sliding_initiator.hpp"

namespace lookout::tools {
namespace {

/// The limits of the levels in docs/initiators.md, chosen there after a first version's figures: levels are
/// words for the reader, claims rest on the figures.
constexpr double kHighDiscrimination = 1.5;
constexpr double kDivergenceCuts[] = {0.1, 1.2, 5.0};
constexpr double kDeclineCuts[] = {0.02, 0.5, 0.6};

double level(double value, const double (&cuts)[3]) {
  double result = 0.0;
  for (const double cut : cuts) result += value >= cut ? 1.0 : 0.0;
  return result;
}

/// CPU time of this thread [ms]: what other programs take does not count.
double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void refuse_refusal(const std::string& name, const tracking::StartedTracks& started) {
  if (!started.refusal.empty()) throw std::runtime_error(name + " refuses the scene: " + started.refusal);
}

}  // namespace

InitiationRun run_initiator(const InitiationScene& scene, const std::string& name,
                            const tracking::InitiatorConfig& config) {
  InitiationRun run;
  run.method = tracking::make_initiator(name, config);
  run.window = scene.window();
  run.method->start(run.window);
  const double start = thread_milliseconds();
  const tracking::StartedTracks& started = run.method->start(run.window);
  run.time_ms = thread_milliseconds() - start;
  refuse_refusal(name, started);
  run.tracks = track_sources(run.window, started);
  run.survivors = sources_of(run.window, started.survivors);
  return run;
}

bool is_refused(const InitiationScene& scene, const std::string& name,
                const tracking::InitiatorConfig& config) {
  return !tracking::make_initiator(name, config)->start(scene.window()).refusal.empty();
}

InitiationRun run_sliding(const InitiationScene& scene, const std::string& name,
                          const tracking::InitiatorConfig& config, int follow_misses) {
  tracking::SlidingParams params;
  params.follow_misses = follow_misses;
  auto method = tracking::make_initiator(name, config);
  params.window_scans = method->window_scans();
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(params.motion.acceleration_sigma);
  tracking::SlidingInitiator sliding(std::move(method), params);
  InitiationRun run;
  const double start = thread_milliseconds();
  for (std::size_t k = 0; k < scene.scans.size(); ++k) {
    const tracking::StartedTracks& started = sliding.add_scan(scene.times[k], scene.scans[k]);
    refuse_refusal(name, started);
    for (auto& track : track_sources(sliding.window(), started)) run.tracks.push_back(std::move(track));
    const auto survivors = sources_of(sliding.window(), started.survivors);
    run.survivors.insert(run.survivors.end(), survivors.begin(), survivors.end());
  }
  run.time_ms = (thread_milliseconds() - start) / static_cast<double>(scene.scans.size());
  return run;
}

void write_scene_picture(const InitiationScene& scene, const InitiationRun& run, const std::string& path) {
  core::CsvWriter csv(path, "kind,id,time_s,x_m,y_m");
  const auto write = [&](const char* kind, std::int64_t id, const tracking::Plot& plot, double time) {
    csv.text(kind).integer(id).number(time).number(plot.position.x()).number(plot.position.y()).end_row();
  };
  std::vector<std::pair<const tracking::Plot*, double>> plots(scene.target_of.size());
  for (std::size_t k = 0; k < scene.scans.size(); ++k) {
    for (const auto& plot : scene.scans[k]) {
      const auto source = static_cast<std::size_t>(plot.source);
      plots[source] = {&plot, scene.times[k]};
      write(scene.target_of[source] < 0 ? "clutter" : "target", scene.target_of[source] + 1, plot,
            scene.times[k]);
    }
  }
  std::int64_t id = 0;
  for (const TrackSources& track : run.tracks) {
    ++id;
    for (const int source : track) {
      const auto& [plot, time] = plots[static_cast<std::size_t>(source)];
      write("track", id, *plot, time);
    }
  }
  csv.close();
}

Metrics track_metrics(const InitiationScene& scene, const InitiationRun& run, int window_scans,
                      TrueTrack reading) {
  const TrackScore score = score_tracks(scene, run.tracks, window_scans, reading);
  Metrics metrics;
  metrics["found"] = score.found_share(scene);
  metrics["false_per_run"] = score.false_tracks;
  metrics["tracks_per_run"] = score.declared;
  metrics["duplicates"] = score.duplicates;
  metrics["p1"] = surviving_share(scene, run.survivors);
  metrics["p2"] = score.found_share(scene);
  if (score.declared > 0)
    metrics["p3"] = {1.0 * score.false_tracks / score.declared, static_cast<double>(score.declared)};
  metrics["time_ms"] = run.time_ms;
  return metrics;
}

Metrics accumulator_metrics(const AccumulatorScore& score) {
  Metrics metrics;
  metrics["discrimination"] = score.discrimination;
  metrics["discrimination_high"] = score.discrimination >= kHighDiscrimination ? 1.0 : 0.0;
  metrics["divergence"] = score.divergence;
  metrics["divergence_level"] = level(score.divergence, kDivergenceCuts);
  metrics["decline"] = score.decline;
  metrics["decline_level"] = level(score.decline, kDeclineCuts);
  metrics["found"] = score.found;
  return metrics;
}

}  // namespace lookout::tools
