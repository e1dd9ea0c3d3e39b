#include <array>
#include <cmath>
#include <stdexcept>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"
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

std::vector<PointScan> read_points(const std::string& path, const tracking::InitiatorConfig& config) {
  static constexpr std::array<std::string_view, 4> kColumns{"scan", "time_s", "x_m", "y_m"};
  const core::CsvTable table(path, kColumns);
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
    scans.back().plots.push_back(plot);
  }
  return scans;
}

void write_track(core::CsvWriter& file, std::int64_t id, const tracking::StartedTrack& track,
                 std::int64_t first_scan) {
  const Eigen::Vector2d start = track.initial_position();
  file.integer(id).number(start.x()).number(start.y()).number(track.state[2]).number(track.state[3]);
  file.number(track.line.rho).number(track.line.theta).number(track.score);
  file.integer(first_scan + track.first_scan).integer(first_scan + track.last_scan).end_row();
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
  const std::vector<PointScan> scans = read_points(options.inputs.front(), config);
  core::CsvWriter file(options.out, "id,x0_m,y0_m,vx_mps,vy_mps,rho_m,theta_rad,score,first_scan,last_scan");
  std::int64_t id = 0;
  for (const PointScan& scan : scans) {
    const auto& started = sliding.add_scan(scan.time, scan.plots);
    if (!started.refusal.empty())
      throw core::InputError(options.inputs.front() + ": scan " + std::to_string(scan.number) + ": " +
                             started.refusal);
    const std::int64_t first_scan = scan.number - (sliding.window().num_scans() - 1);
    for (const auto& track : started.tracks) write_track(file, ++id, track, first_scan);
  }
  file.close();
  log_info(std::to_string(id) + " tracks started in " + std::to_string(scans.size()) + " scans; wrote " +
           options.out);
  return 0;
}

}  // namespace lookout::tools
