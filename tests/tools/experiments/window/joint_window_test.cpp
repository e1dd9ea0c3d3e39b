#include "tools/experiments/window/joint_window.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/csv.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

constexpr std::array<std::string_view, 5> kTrajectory{"north_m", "east_m", "north_velocity_mps",
                                                      "east_velocity_mps", "weight"};

TEST(JointWindow, ShowsSeedsClustersAndWhatBecameOfThem) {
  const tests::TemporaryDirectory folder;
  auto scene = load_variant("window_table2.yaml", {0.3, 0.1, 3.0, sonar_sim::ClutterReading::literal});
  scene.duration = 10.0;
  const auto scans = simulate(scene, 1000, 0);
  write_joint_window(scans, sonar_sim::known_params(scene, scene.platforms.front()), 1000, folder.path());
  const core::CsvTable seeds(folder.file("joint_seeds.csv"), kTrajectory);
  const core::CsvTable clusters(folder.file("joint_clusters.csv"), kTrajectory);
  constexpr std::array<std::string_view, 2> kPlace{"north_m", "east_m"};
  const core::CsvTable elements(folder.file("joint_elements.csv"), kPlace);
  ASSERT_EQ(elements.num_rows(), 3u);  // [Yan2018] Table 2 has three targets
  EXPECT_GE(seeds.num_rows(), 1u);
  ASSERT_GE(clusters.num_rows(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {  // the accepted ones come first, the elements likewise
    EXPECT_GT(clusters.number(row, "weight"), 0.0);
    EXPECT_NEAR(clusters.number(row, "north_m"), elements.number(row, "north_m"), 1.0);
  }
  constexpr std::array<std::string_view, 3> kEcho{"time_s", "north_m", "east_m"};
  // Twenty scans, nine tenths of three targets each, and some 26 false alarms.
  EXPECT_GT(core::CsvTable(folder.file("joint_echoes.csv"), kEcho).num_rows(), 20u * 15u);
}

}  // namespace
}  // namespace lookout::tools
