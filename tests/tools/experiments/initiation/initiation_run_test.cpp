#include "tools/experiments/initiation/initiation_run.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/files/csv.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

InitiationScene ideal_scene() {
  core::Random random(1001);
  FanSceneParams params;
  params.situation = "I";
  return fan_scene(params, random);
}

TEST(InitiationRun, TheIdealSceneHasEveryTargetOnce) {
  const InitiationScene scene = ideal_scene();
  const InitiationRun run = run_initiator(scene, "vct", {});
  const Metrics metrics = track_metrics(scene, run, 7, TrueTrack::share);
  EXPECT_EQ(metrics.at("p2").value, 1.0);
  EXPECT_EQ(metrics.at("false_per_run").value, 0.0);
}

TEST(InitiationRun, TheScenesPictureHoldsPlotsAndTracks) {
  const tests::TemporaryDirectory directory;
  const InitiationScene scene = ideal_scene();
  tracking::InitiatorConfig config;
  config.window_scans = 7;
  config.min_plots = 7;
  write_scene_picture(scene, run_initiator(scene, "vct", config), directory.path() + "/scene.csv");
  constexpr std::array<std::string_view, 5> kColumns{"kind", "id", "time_s", "x_m", "y_m"};
  const core::CsvTable table(directory.path() + "/scene.csv", kColumns);
  EXPECT_EQ(table.num_rows(), 2u * 3u * 7u);  // Three targets of seven plots, and three tracks of them.
  EXPECT_EQ(table.text(table.num_rows() - 1, "kind"), "track");
}

TEST(InitiationRun, TellsARefusal) {
  core::Random random(1002);
  EXPECT_FALSE(is_refused(ideal_scene(), "mht_ti", {}));
  EXPECT_TRUE(is_refused(real_scene(2000.0, 60.0, random), "mht_ti", {}));  // 2.4e7 pairs.
}

}  // namespace
}  // namespace lookout::tools
