#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "core/random.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/cli/pgm.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

constexpr std::array<std::string_view, 7> kColumns{"time_s", "id",    "x_px",     "y_px",
                                                   "vx_px",  "vy_px", "existence"};
const std::string kExample = std::string(LOOKOUT_SOURCE_DIR) + "/tools/data/tbd_example";

Options example(const std::string& method, const std::string& out) {
  Options options;
  options.method = method;
  options.inputs = {kExample};
  options.config = kExample + "/config.yaml";
  options.out = out;
  return options;
}

TEST(TbdCommand, FindsBothTargetsOfTheShippedExample) {
  const tests::TemporaryDirectory directory;
  for (const char* method : {"h_pmht", "i_h_pmht_4", "i_h_pmht_1", "immpda_ai"}) {
    const std::string out = directory.path() + "/tracks.csv";
    ASSERT_EQ(tbd_command(example(method, out)), 0);
    const core::CsvTable table(out, kColumns);
    ASSERT_GE(table.num_rows(), 2u) << method;
    for (std::size_t row = table.num_rows() - 2; row < table.num_rows(); ++row) {
      EXPECT_EQ(table.number(row, "time_s"), 19.0);
      const double x = table.number(row, "x_px"), y = table.number(row, "y_px");
      // Truth of the last frame, from truth.csv; within a pixel, the blocks of immpda_ai being 5 px wide.
      const double error = std::min(std::hypot(x - 71.5, y - 35.2), std::hypot(x - 28.5, y - 41.0));
      EXPECT_LT(error, std::string(method) == "immpda_ai" ? 3.0 : 1.0) << method;
    }
  }
}

std::string error_of(const Options& options) {
  try {
    tbd_command(options);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TbdCommand, RefusesBadInputInOneLine) {
  const tests::TemporaryDirectory directory;
  const std::string out = directory.path() + "/tracks.csv";
  EXPECT_NE(error_of(example("kalman", out)).find("expected one of"), std::string::npos);
  EXPECT_NE(error_of(example("h_pmht", "")).find("--out"), std::string::npos);
  const std::string frames = directory.path() + "/frames";
  std::filesystem::create_directory(frames);
  Options options = example("i_h_pmht_4", out);
  options.inputs = {frames};
  EXPECT_NE(error_of(options).find("no .pgm"), std::string::npos);
  write_pgm(frames + "/0.pgm", {4, 4, std::vector<double>(16, 1.0)});
  write_pgm(frames + "/1.pgm", {4, 5, std::vector<double>(20, 1.0)});
  EXPECT_NE(error_of(options).find("1.pgm: is 4 x 5 pixels, expected 4 x 4"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));  // nothing half-written
}

}  // namespace
}  // namespace lookout::tools
