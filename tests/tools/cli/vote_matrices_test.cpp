#include "tools/cli/vote_matrices.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

/// One target that stands 40 m ahead of a vehicle at rest, seen in every one of twenty scans.
core::Recording standing_target() {
  core::Recording recording;
  for (int k = 0; k < 20; ++k) {
    core::SonarScan scan;
    scan.utime = 500'000 * k;
    scan.first_bearing = core::radians(-44.5);
    scan.bearing_step = core::radians(1.0);
    scan.num_beams = 90;
    scan.max_range = 150.0;
    scan.returns = {{core::radians(0.5), 40.0, 1.0}};
    recording.scans.push_back(scan);
    recording.vehicle.push_back({scan.utime, {}, {0, 0}});
  }
  return recording;
}

TEST(VoteMatrices, PeakLiesAtTheTarget) {
  const tests::TemporaryDirectory folder;
  write_vote_matrices(standing_target(), {}, core::microseconds(9.5), folder.path());
  static constexpr std::array<std::string_view, 5> kColumns{"axis", "velocity_mps", "intercept_m", "votes",
                                                            "threshold"};
  const core::CsvTable votes(folder.file("votes.csv"), kColumns);
  double best = 0.0, velocity = 99.0, intercept = 0.0;
  for (std::size_t row = 0; row < votes.num_rows(); ++row) {
    if (votes.text(row, "axis") != "north" || votes.number(row, "votes") <= best) continue;
    best = votes.number(row, "votes");
    velocity = votes.number(row, "velocity_mps");
    intercept = votes.number(row, "intercept_m");
  }
  EXPECT_NEAR(velocity, 0.0, 0.5);  // one step of the grid
  EXPECT_NEAR(intercept, 40.0, 3.0);
}

TEST(VoteMatrices, NoScanByThenIsAnError) {
  const tests::TemporaryDirectory folder;
  EXPECT_THROW(write_vote_matrices(standing_target(), {}, -1, folder.path()), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
