#include "tools/cli/vote_matrices.hpp"

#include "core/files/csv.hpp"
#include "core/files/time_text.hpp"
#include "core/input_error.hpp"
#include "csht/csht_estimator.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kAxes[] = {"north", "east"};

void write_votes(const csht::CshtEstimator& estimator, const std::string& path) {
  core::CsvWriter csv(path, "axis,velocity_mps,intercept_m,votes,threshold");
  for (int axis = 0; axis < 2; ++axis) {
    const csht::VoteSnapshot& snapshot = estimator.snapshot(axis);
    for (const auto& cell : snapshot.cells) {
      csv.text(kAxes[axis]).number(cell.velocity).number(cell.intercept).number(cell.votes);
      csv.number(snapshot.threshold).end_row();
    }
  }
  csv.close();
}

void write_classes(const csht::CshtEstimator& estimator, const std::string& path) {
  core::CsvWriter csv(path, "axis,velocity_mps,intercept_m");
  for (int axis = 0; axis < 2; ++axis) {
    for (const auto& line : estimator.snapshot(axis).classes)
      csv.text(kAxes[axis]).number(line.velocity).number(line.intercept).end_row();
  }
  csv.close();
}

}  // namespace

void write_vote_matrices(const core::Recording& recording, const core::SonarParams& sensor,
                         std::int64_t utime, const std::string& directory) {
  csht::CshtEstimator estimator(csht::CshtParams::tracking(), sensor);
  estimator.keep_snapshots();
  core::PoseHistory history;
  auto state = recording.vehicle.begin();
  bool any = false;
  for (const auto& scan : recording.scans) {
    if (scan.utime > utime) break;
    while (state != recording.vehicle.end() && !history.reaches(scan.utime)) history.add(*state++);
    const auto body = history.at(scan.utime);
    if (!body) continue;
    estimator.update({scan, core::compose(*body, scan.T_body_sonar)});
    any = true;
  }
  if (!any) throw core::InputError("--votes-at: no scan with a pose by " + core::time_text(utime) + " s");
  write_vote_matrices(estimator, directory);
}

void write_vote_matrices(const csht::CshtEstimator& estimator, const std::string& directory) {
  write_votes(estimator, directory + "/votes.csv");
  write_classes(estimator, directory + "/classes.csv");
}

}  // namespace lookout::tools
