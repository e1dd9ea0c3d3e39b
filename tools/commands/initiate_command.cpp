#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"
#include "tools/experiments/initiation/initiation_score.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/initiation/sliding_initiator.hpp"

namespace lookout::tools {
namespace {

/// One scan of recorded points. Scan numbers that are left out are scans without points.
struct PointScan {
  std::int64_t number = 0;
  double time = 0.0;
  std::vector<tracking::Plot> plots;
};

constexpr std::size_t kMostPoints = 30'000;        // Of a scan, as of a sonar's returns.
constexpr std::int64_t kMostEmptyScans = 100'000;  // A larger gap is a mistake of units, not silence.

void check_order(const core::CsvTable& table, std::size_t row, const PointScan& before,
                 const PointScan& scan) {
  if (scan.number < before.number) table.fail(row, "scan", "scans must be in rising order");
  if (scan.number == before.number && scan.time != before.time)
    table.fail(row, "time_s", "all points of a scan have one time");
  if (scan.number > before.number && scan.time <= before.time)
    table.fail(row, "time_s", "a scan must be later than the one before");
  if (scan.number - before.number > kMostEmptyScans)
    table.fail(row, "scan", "more than 100000 scans are left out");
}

/// Scans without points between two that have some, at times spread evenly between theirs.
void fill_gap(std::vector<PointScan>& scans, const PointScan& next) {
  const PointScan before = scans.back();
  const std::int64_t steps = next.number - before.number;
  for (std::int64_t i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    scans.push_back({before.number + i, before.time + share * (next.time - before.time), {}});
  }
}

std::vector<PointScan> read_points(const core::CsvTable& table, const tracking::InitiatorConfig& config) {
  std::vector<PointScan> scans;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    const PointScan scan{table.integer(row, "scan"), table.number(row, "time_s"), {}};
    if (!scans.empty()) check_order(table, row, scans.back(), scan);
    if (scans.empty() || scan.number > scans.back().number) {
      if (!scans.empty()) fill_gap(scans, scan);
      scans.push_back(scan);
    }
    // A blank point says that the scan is empty.
    if (table.empty(row, "x_m") && table.empty(row, "y_m")) continue;
    tracking::Plot plot;
    plot.position = {table.number(row, "x_m"), table.number(row, "y_m")};
    if (scans.back().plots.size() == kMostPoints) table.fail(row, "scan", "has more than 30000 points");
    plot.noise = config.noise_at(plot.position);
    plot.source = static_cast<int>(row);
    scans.back().plots.push_back(plot);
  }
  return scans;
}

constexpr const char* kTargetColumn = "target";

/// Whose each point is, where POINTS.csv says so: of each row its target, or -1.
InitiationScene scene_of(const core::CsvTable& table) {
  InitiationScene scene;
  std::map<std::int64_t, int> targets;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    scene.target_of.push_back(-1);
    if (table.empty(row, kTargetColumn) || table.integer(row, kTargetColumn) == 0) continue;
    if (table.integer(row, kTargetColumn) < 0)
      table.fail(row, kTargetColumn, "is >= 0, 0 or blank of clutter");
    scene.target_of.back() =
        targets.try_emplace(table.integer(row, kTargetColumn), static_cast<int>(targets.size()))
            .first->second;
  }
  scene.num_targets = static_cast<int>(targets.size());
  return scene;
}

/// Says how the started tracks compare with the points' own targets.
void report_score(const core::CsvTable& table, const std::vector<TrackSources>& tracks) {
  if (!table.has(kTargetColumn)) return;
  const InitiationScene scene = scene_of(table);
  if (scene.num_targets == 0) return;
  const TrackScore score = score_tracks(scene, tracks, 0, TrueTrack::share);
  log_info("score: " + std::to_string(score.targets_found) + " of " + std::to_string(scene.num_targets) +
           " targets with a true track (P2 " + core::shortest(score.found_share(scene)) + "), " +
           std::to_string(score.false_tracks) + " of " + std::to_string(score.declared) + " tracks false, " +
           std::to_string(score.duplicates) +
           " repeated; a track is true by three quarters of "
           "its points");
}

/// The rows of POINTS.csv, the first below the header is 1, that a track is made of.
std::string rows_of(const TrackSources& sources) {
  std::string rows;
  for (const int source : sources) {
    if (!rows.empty()) rows.append(" ");
    rows.append(std::to_string(source + 1));
  }
  return rows;
}

void write_covariance(core::CsvWriter& file, const Eigen::Matrix4d& covariance) {
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    for (Eigen::Index j = i; j < covariance.cols(); ++j) file.number(covariance(i, j));
  }
}

void write_track(core::CsvWriter& file, std::int64_t id, const tracking::StartedTrack& track,
                 std::int64_t first_scan, const TrackSources& sources) {
  const Eigen::Vector2d start = track.initial_position();
  file.integer(id).number(start.x()).number(start.y()).number(track.state[2]).number(track.state[3]);
  file.number(track.line.rho).number(track.line.theta).number(track.score);
  file.integer(first_scan + track.first_scan).integer(first_scan + track.last_scan);
  file.text(rows_of(sources)).number(track.state[0]).number(track.state[1]);
  write_covariance(file, track.covariance);
  file.end_row();
}

tracking::SlidingInitiator make_sliding(const std::string& method, const tracking::InitiatorConfig& config) {
  try {
    auto initiator = tracking::make_initiator(method, config);
    tracking::SlidingParams params;
    params.window_scans = initiator->window_scans();
    params.motion.acceleration_sigma = config.acceleration_sigma.value_or(params.motion.acceleration_sigma);
    return {std::move(initiator), params};
  } catch (const std::invalid_argument& error) {
    throw core::InputError("initiate: " + std::string(error.what()));
  }
}

}  // namespace

int initiate_command(const Options& options) {
  if (options.out.empty()) throw core::InputError("initiate: --out TRACKS.csv is missing");
  const tracking::InitiatorConfig config = load_configuration(options, {}, options.method).initiator;
  auto sliding = make_sliding(options.method, config);
  static constexpr std::array<std::string_view, 4> kColumns{"scan", "time_s", "x_m", "y_m"};
  const core::CsvTable table(options.inputs.front(), kColumns);
  const std::vector<PointScan> scans = read_points(table, config);
  core::CsvWriter file(
      options.out,
      "id,x0_m,y0_m,vx_mps,vy_mps,rho_m,theta_rad,score,first_scan,last_scan,points,x_m,y_m,"
      "cov_x_x,cov_x_y,cov_x_vx,cov_x_vy,cov_y_y,cov_y_vx,cov_y_vy,cov_vx_vx,cov_vx_vy,cov_vy_vy");
  std::int64_t id = 0;
  std::vector<TrackSources> sources;
  for (const PointScan& scan : scans) {
    const auto& started = sliding.add_scan(scan.time, scan.plots);
    if (!started.refusal.empty())
      throw core::InputError(options.inputs.front() + ": scan " + std::to_string(scan.number) + ": " +
                             started.refusal);
    const std::int64_t first_scan = scan.number - (sliding.window().num_scans() - 1);
    const auto own = track_sources(sliding.window(), started);
    for (std::size_t i = 0; i < own.size(); ++i)
      write_track(file, ++id, started.tracks[i], first_scan, own[i]);
    sources.insert(sources.end(), own.begin(), own.end());
  }
  file.close();
  report_score(table, sources);
  log_info(std::to_string(id) + " tracks started in " + std::to_string(scans.size()) + " scans; wrote " +
           options.out);
  return 0;
}

}  // namespace lookout::tools
