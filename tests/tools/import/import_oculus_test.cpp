#include "tools/import/import_oculus.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/import/oculus_bytes.hpp"

namespace lookout::tools {
namespace {

std::string pings(const std::vector<std::uint32_t>& numbers) {
  std::string bytes;
  for (const std::uint32_t number : numbers) {
    tests::OculusSpec spec;
    spec.number = number;
    spec.start = 0.25 * number;
    bytes += oculus_packet(spec);
  }
  return bytes;
}

TEST(ImportOculus, OfSeveralFilesMakesOneRecording) {
  const tests::TemporaryDirectory directory;
  const std::string out = directory.file("out");
  const ImportSummary summary =
      import_oculus({directory.write("a.raw", pings({4, 5})), directory.write("b.raw", pings({6}))}, out);
  EXPECT_TRUE(summary.left_out.empty());
  const core::ImageReader images(out);
  ASSERT_EQ(images.size(), 3u);
  EXPECT_EQ(images.utime(2), 500'000);  // A quarter of a second a ping.
  EXPECT_EQ(images.read(1).sequence, 5);
  const core::Recording recording = core::read_recording(out);
  EXPECT_TRUE(recording.is_fixed);
  EXPECT_EQ(recording.params->num_beams, 4);
  EXPECT_NEAR(recording.params->max_range, 0.75, 1e-12);
  EXPECT_NEAR(recording.params->scan_period, 0.25, 1e-12);
}

TEST(ImportOculus, KeepsWhatIsWholeAndNamesTheRest) {
  const tests::TemporaryDirectory directory;
  const std::string whole = pings({1, 2, 3});
  const std::string cut = directory.write("cut.raw", whole.substr(0, whole.size() - 5));
  const ImportSummary summary = import_oculus({cut}, directory.file("out"));
  EXPECT_EQ(core::ImageReader(directory.file("out")).size(), 2u);
  ASSERT_EQ(summary.left_out.size(), 1u);
  EXPECT_NE(summary.left_out[0].find("is cut off or damaged"), std::string::npos);
}

TEST(ImportOculus, WithoutAPingNothingIsWritten) {
  const tests::TemporaryDirectory directory;
  const std::string text = directory.write("notes.txt", "no sonar here");
  EXPECT_NE(
      testing::error_of([&] { import_oculus({text}, directory.file("out")); }).find("no whole Oculus ping"),
      std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(directory.file("out")));
}

// The figures are those that came with the file: pings, bearings, size and mean values.
TEST(ImportOculus, TakesTheRealPingsWhole) {
  const char* data = std::getenv("LOOKOUT_DATA");
  if (data == nullptr) GTEST_SKIP() << "LOOKOUT_DATA does not name the folder of the Oculus pings";
  const tests::TemporaryDirectory directory;
  const ImportSummary summary =
      import_oculus({std::string(data) + "/oculus/three_pings_8bit.raw"}, directory.path());
  EXPECT_TRUE(summary.left_out.empty());
  const core::ImageReader images(directory.path());
  ASSERT_EQ(images.size(), 3u);
  const double means[] = {55.86, 56.13, 55.61};
  for (std::size_t i = 0; i < 3; ++i) {
    const core::SonarImage image = images.read(i);
    EXPECT_EQ(image.sequence, 415323 + static_cast<std::int64_t>(i));
    EXPECT_NEAR(core::seconds(image.utime), 0.0625021 * static_cast<double>(i), 1e-6);
    ASSERT_EQ(image.num_beams(), 256);
    ASSERT_EQ(image.num_bins, 703);
    EXPECT_NEAR(core::degrees(image.bearings.front()), -30.0, 1e-9);
    EXPECT_NEAR(core::degrees(image.bearings.back()), 30.0, 1e-9);
    EXPECT_NEAR(image.range_step, 2.842e-3, 1e-6);
    const double sum = std::accumulate(image.intensity.begin(), image.intensity.end(), 0.0);
    EXPECT_NEAR(sum / static_cast<double>(image.intensity.size()), means[i], 0.005);
  }
}

}  // namespace
}  // namespace lookout::tools
