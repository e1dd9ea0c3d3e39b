#include "tools/experiments/experiment_registry.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

// The names that scripts outside the repository rely on.
constexpr std::array kNames{"csht-window",   "csht-ablation", "csht-tracking", "limits",      "recordings",
                            "nht-simulated", "nht-real",      "agfht-table2",  "agfht-sweep", "hpmht-video",
                            "hpmht-sonar",   "t2gt",          "two-uuv",       "manoeuvres",  "sea",
                            "faults",        "image-sea",     "sensors"};

TEST(ExperimentRegistry, HasEveryPublishedName) {
  for (const char* name : kNames) EXPECT_NE(make_experiment(name), nullptr) << name;
  try {
    make_experiment("csht");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("expected one of: csht-window"), std::string::npos);
  }
}

TEST(ExperimentRegistry, EveryCellIsItsOwnAndEveryPlotScriptExists) {
  for (const auto& entry : experiment_registry()) {
    const auto experiment = entry.make();
    EXPECT_FALSE(experiment->summary().empty()) << entry.name;
    EXPECT_FALSE(experiment->scenario().empty()) << entry.name;
    const std::string plots = experiment->plot_script();
    EXPECT_TRUE(plots.empty() || std::filesystem::exists(LOOKOUT_SOURCE_DIR "/tools/" + plots)) << plots;
    using Key = std::pair<std::string, std::vector<std::pair<std::string, ParameterValue>>>;
    std::set<Key> seen;
    for (const auto& cell : experiment->cells())
      EXPECT_TRUE(seen.emplace(cell.method, cell.parameters.values()).second)
          << entry.name << " " << cell.method;
  }
}

}  // namespace
}  // namespace lookout::tools
