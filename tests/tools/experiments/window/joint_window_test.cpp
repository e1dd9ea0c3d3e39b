#include "tools/experiments/window/joint_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/files/csv.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

constexpr std::array<std::string_view, 5> kTrajectory{"north_m", "east_m", "north_velocity_mps",
                                                      "east_velocity_mps", "weight"};

TEST(JointWindow, ShowsDensitiesHypothesesAndWhatIsReported) {
  const tests::TemporaryDirectory folder;
  auto scene = load_variant("window_table2.yaml", {0.3, 0.1, 3.0, sonar_sim::ClutterReading::literal});
  scene.duration = 10.0;
  const auto scans = simulate(scene, 1000, 0);
  write_joint_window(scans, sonar_sim::known_params(scene, scene.platforms.front()), 1000, folder.path());
  const core::CsvTable clouds(folder.file("joint_clouds.csv"), kTrajectory);
  const core::CsvTable means(folder.file("joint_hypotheses.csv"), kTrajectory);
  constexpr std::array<std::string_view, 2> kPlace{"north_m", "east_m"};
  const core::CsvTable elements(folder.file("joint_elements.csv"), kPlace);
  ASSERT_EQ(elements.num_rows(), 3u);  // [Yan2018] Table 2 has three targets
  ASSERT_GE(means.num_rows(), 3u);
  EXPECT_GT(clouds.num_rows(), 100u * means.num_rows());
  for (std::size_t row = 0; row < 3; ++row) {  // each element is the mean of a hypothesis
    double nearest = 1e9;
    for (std::size_t k = 0; k < means.num_rows(); ++k)
      nearest = std::min(nearest, std::abs(means.number(k, "north_m") - elements.number(row, "north_m")));
    EXPECT_LT(nearest, 1e-9);
  }
  constexpr std::array<std::string_view, 3> kDetection{"time_s", "north_m", "east_m"};
  // Twenty scans, nine tenths of three targets each, and some 26 false alarms.
  EXPECT_GT(core::CsvTable(folder.file("joint_detections.csv"), kDetection).num_rows(), 20u * 15u);
}

}  // namespace
}  // namespace lookout::tools
