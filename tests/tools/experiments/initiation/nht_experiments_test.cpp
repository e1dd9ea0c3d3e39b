#include "tools/experiments/initiation/nht_experiments.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

/// The files that an experiment writes for its pictures of the cells that pass.
template <typename Passes>
std::set<std::string> files_of(const Experiment& experiment, Passes passes) {
  const tests::TemporaryDirectory directory;
  Drawn drawn;
  drawn.directory = directory.path();
  for (const Cell& cell : experiment.cells()) {
    if (passes(cell)) drawn.cells.push_back(cell);
  }
  experiment.write_extras(drawn);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
    names.insert(entry.path().filename().string());
  return names;
}

TEST(NhtSimulated, DrawsTheSituationsAndReadingsThatAreLeft) {
  const auto names = files_of(*make_nht_simulated(), [](const Cell& cell) {
    return cell.method == "nht_ti" && cell.parameters.text("variant") == "cell" &&
           cell.parameters.text("situation") == "IV";
  });
  EXPECT_EQ(names, (std::set<std::string>{"accumulator_IV_nht_ti_cell.csv", "scene_IV_nht_ti_cell.csv"}));
}

TEST(NhtReal, DrawsTheClutterThatIsLeft) {
  const auto names = files_of(*make_nht_real(), [](const Cell& cell) {
    return cell.method == "vct" && cell.parameters.number("clutter_per_scan") == 50.0;
  });
  EXPECT_EQ(names, std::set<std::string>{"scene_real_vct.csv"});
  // Of the printed density alone nothing is drawn.
  EXPECT_TRUE(files_of(*make_nht_real(), [](const Cell& cell) {
                return cell.parameters.number("clutter_per_scan") == 4500.0;
              }).empty());
}

}  // namespace
}  // namespace lookout::tools
