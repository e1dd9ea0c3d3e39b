#include "tools/import/import_pgm.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files/grey_image.hpp"
#include "core/files/image_recording.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kTwoBeams = "beam_bearings_deg: [-10, 5]\nrange_step: 0.5\nping_period: 0.1\n";

/// A folder with pictures of 3 columns and 2 rows.
class Folder {
 public:
  explicit Folder(const std::string& geometry) {
    std::filesystem::create_directory(directory_.file("in"));
    directory_.write("in/geometry.yaml", geometry);
    picture("ping3.pgm");
    picture("ping4.pgm");
  }
  void picture(const std::string& name) const {
    core::write_pgm(directory_.file("in/" + name), {3, 2, {1, 2, 3, 4, 5, 6}});
  }
  ImportSummary import() const { return import_pgm(directory_.file("in"), "", out()); }
  std::string out() const { return directory_.file("out"); }
  const tests::TemporaryDirectory& directory() const { return directory_; }

 private:
  tests::TemporaryDirectory directory_;
};

TEST(ImportPgm, ARowABeamByDefault) {
  const Folder folder(kTwoBeams);
  folder.picture("ping6.pgm");
  EXPECT_TRUE(folder.import().left_out.empty());
  const core::ImageReader images(folder.out());
  ASSERT_EQ(images.size(), 3u);
  const core::SonarImage image = images.read(2);
  EXPECT_EQ(image.utime, 300'000);  // Ping 5 is missing: three periods after ping 3.
  EXPECT_EQ(image.intensity, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_NEAR(core::degrees(image.bearings[1]), 5.0, 1e-12);
  EXPECT_EQ(image.first_range, 0.25);
}

TEST(ImportPgm, AsDisplaysDrawItColumnsAreBeamsAndTheTopIsFar) {
  const Folder folder(
      "num_beams: 3\nfirst_bearing_deg: 10\nbearing_step_deg: -10\nrows: ranges\nranges_from: far\n"
      "min_range: 1\nmax_range: 3\nping_period: 0.1\nintensity_scale: 2\n");
  folder.import();
  const core::SonarImage image = core::ImageReader(folder.out()).read(0);
  // Beams from starboard: the last column is the first from port; its near value is 6, its far one 3.
  EXPECT_EQ(image.intensity, (std::vector<double>{12, 6, 10, 4, 8, 2}));
  EXPECT_EQ(image.first_range, 1.5);  // Two ranges from 1 to 3 m.
  EXPECT_NEAR(core::degrees(image.bearings[0]), -10.0, 1e-9);
}

TEST(ImportPgm, TakesTimesFromATable) {
  const Folder folder("beam_bearings_deg: [-10, 5]\nrange_step: 0.5\ntimes: times.csv\n");
  folder.directory().write("in/times.csv", "file,time_s\nping3.pgm,12.5\n");
  const ImportSummary summary = folder.import();
  EXPECT_EQ(core::ImageReader(folder.out()).utime(0), 12'500'000);
  ASSERT_EQ(summary.left_out.size(), 1u);
  EXPECT_NE(summary.left_out[0].find("ping4.pgm: has no time"), std::string::npos);
}

TEST(ImportPgm, KeepsWhatIsWholeAndNamesTheRest) {
  const Folder folder(kTwoBeams);
  folder.directory().write("in/ping7.pgm", "P5\n3 2\n255\nab");
  core::write_pgm(folder.directory().file("in/ping8.pgm"), {3, 4, std::vector<double>(12, 1.0)});
  const ImportSummary summary = folder.import();
  EXPECT_EQ(core::ImageReader(folder.out()).size(), 2u);
  ASSERT_EQ(summary.left_out.size(), 2u);
  EXPECT_NE(summary.left_out[0].find("ping7.pgm: is truncated: holds 2 of 6 pixels"), std::string::npos);
  EXPECT_NE(summary.left_out[1].find("ping8.pgm: has 4 beams, expected 2"), std::string::npos);
}

TEST(ImportPgm, SaysWhatIsWrongWithTheGeometry) {
  const auto error = [](const std::string& geometry) {
    const Folder folder(geometry);
    const std::string text = testing::error_of([&] { folder.import(); });
    EXPECT_FALSE(std::filesystem::exists(folder.out())) << geometry;
    return text.substr(text.find("geometry.yaml"));
  };
  EXPECT_NE(error("range_step: 1\nping_period: 1\n").find("num_beams"), std::string::npos);
  EXPECT_NE(error("beam_bearings_deg: [1, 1]\nrange_step: 1\nping_period: 1\n").find("rise or fall"),
            std::string::npos);
  EXPECT_NE(error("beam_bearings_deg: [1, 2]\nping_period: 1\n").find("range_step"), std::string::npos);
  EXPECT_NE(error("beam_bearings_deg: [1, 2]\nrange_step: 1\n").find("ping_period"), std::string::npos);
  EXPECT_NE(error(std::string(kTwoBeams).append("colour: red\n")).find("colour"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
