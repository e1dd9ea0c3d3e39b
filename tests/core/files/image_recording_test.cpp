#include "core/files/image_recording.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files/grey_image.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

using tests::TemporaryDirectory;

/// Two uneven beams of three bins, in whole steps of an instrument of 8 bits.
SonarImage image_at(std::int64_t utime) {
  SonarImage image;
  image.utime = utime;
  image.sequence = 40 + utime;
  image.sensor_id = 3;
  image.T_body_sonar = {1.5, -0.25, 0.1};
  image.bearings = {-0.3, 0.1};
  image.first_range = 0.7;
  image.range_step = 0.1;
  image.num_bins = 3;
  image.intensity = {0.1, 0.2, 0.3, 0.4, 0.5, 1.7};
  quantise(image, 255.0);
  return image;
}

void expect_same(const SonarImage& a, const SonarImage& b) {
  EXPECT_EQ(a.utime, b.utime);
  EXPECT_EQ(a.sequence, b.sequence);
  EXPECT_EQ(a.sensor_id, b.sensor_id);
  EXPECT_EQ(a.T_body_sonar.heading, b.T_body_sonar.heading);
  EXPECT_EQ(a.bearings, b.bearings);
  EXPECT_EQ(a.first_range, b.first_range);
  EXPECT_EQ(a.range_step, b.range_step);
  EXPECT_EQ(a.num_bins, b.num_bins);
  EXPECT_EQ(a.intensity, b.intensity);
}

void write(const TemporaryDirectory& directory, const std::vector<SonarImage>& images) {
  ImageWriter writer(directory.path());
  for (const auto& image : images) writer.add(image);
  writer.close();
}

TEST(ImageRecording, ReadsBackToTheBit) {
  const TemporaryDirectory directory;
  SonarImage second = image_at(2);
  second.bearings = {-0.3, 0.2};  // The operator chose another sector and range.
  second.range_step = 0.2;
  write(directory, {image_at(1), second});
  const ImageReader reader(directory.path());
  ASSERT_EQ(reader.size(), 2u);
  expect_same(reader.read(0), image_at(1));
  expect_same(reader.read(1), second);
  EXPECT_EQ(reader.utime(1), 2);
}

TEST(ImageRecording, KeepsNegativeIntensities) {
  const TemporaryDirectory directory;
  SonarImage image = image_at(1);
  image.intensity = {-3.0, 0.0, 4.0, 1.0, -1.0, 2.0};  // Of a sonar that reports decibels.
  image.intensity_scale = 1.0;
  write(directory, {image});
  EXPECT_EQ(ImageReader(directory.path()).read(0).intensity, image.intensity);
}

TEST(ImageRecording, WithoutAScaleKeepsHalfAStepOfSixteenBits) {
  const TemporaryDirectory directory;
  SonarImage image = image_at(1);
  image.intensity = {0.0, 1.0 / 3.0, 1e-3, 1.0, 0.5, 0.25};
  image.intensity_scale = 0.0;
  write(directory, {image});
  const SonarImage back = ImageReader(directory.path()).read(0);
  for (std::size_t i = 0; i < image.intensity.size(); ++i)
    EXPECT_NEAR(back.intensity[i], image.intensity[i], 0.5 / 65534.0 + 1e-12);
}

TEST(ImageRecording, IsNoneBeforeItIsClosed) {
  const TemporaryDirectory directory;
  ImageWriter writer(directory.path());
  writer.add(image_at(1));
  EXPECT_FALSE(holds_images(directory.path()));
  writer.close();
  EXPECT_TRUE(holds_images(directory.path()));
}

TEST(ImageRecording, AnotherTakesItsPlaceAndStrangeFilesStay) {
  const TemporaryDirectory directory;
  write(directory, {image_at(1), image_at(2)});
  write_pgm(directory.file("images/mine.pgm"), {1, 1, {0}});
  write(directory, {image_at(5)});
  EXPECT_EQ(ImageReader(directory.path()).size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(directory.file("images/000001.pgm")));
  EXPECT_TRUE(std::filesystem::exists(directory.file("images/mine.pgm")));
}

/// What is said of a recording with this images.csv.
std::string refusal_of(const std::string& index) {
  const TemporaryDirectory directory;
  write(directory, {image_at(1)});
  directory.write("images.csv", index);
  const std::string error = testing::error_of([&] { ImageReader(directory.path()).read(0); });
  return error.substr(error.find_last_of('/') + 1);
}

TEST(ImageRecording, NeedsTimeFileAndRangesAlone) {
  EXPECT_EQ(refusal_of("time_s,file,first_range_m,range_step_m\n0.5,images/000000.pgm,0,0.1\n"), "no error");
}

TEST(ImageRecording, NamesLineAndColumnOfWhatItRefuses) {
  const std::string header = "time_s,file,first_range_m,range_step_m,bearings\n";
  EXPECT_EQ(refusal_of(header + "0,images/000000.pgm,0,0,0\n").substr(0, 43),
            "images.csv:2: range_step_m: expected a numb");
  EXPECT_NE(refusal_of(header + "0,images/000000.pgm,0,1,7\n").find("bearings: is no table"),
            std::string::npos);
  EXPECT_NE(refusal_of(header + "1,a.pgm,0,1,0\n0,b.pgm,0,1,0\n").find("goes back in time"),
            std::string::npos);
  EXPECT_NE(refusal_of(header + "1,a.pgm,0,1,0\n1,b.pgm,0,1,0\n").find("stands twice"), std::string::npos);
  EXPECT_NE(refusal_of(header + "1,none.pgm,0,1,0\n").find("cannot be read"), std::string::npos);
}

TEST(ImageRecording, AnImageOfAnotherSizeIsNamed) {
  const TemporaryDirectory directory;
  write(directory, {image_at(1)});
  write_pgm(directory.file("images/000000.pgm"), {3, 5, std::vector<double>(15, 1.0)});
  const std::string error = testing::error_of([&] { ImageReader(directory.path()).read(0); });
  EXPECT_NE(error.find("000000.pgm: has 5 rows, expected 2, one a beam"), std::string::npos);
}

TEST(ImageRecording, BearingsThatDoNotIncreaseAreRefused) {
  const TemporaryDirectory directory;
  write(directory, {image_at(1)});
  directory.write("bearings.csv", "table,beam,bearing_deg\n0,0,1\n0,1,1\n");
  const std::string error = testing::error_of([&] { ImageReader(directory.path()); });
  EXPECT_NE(error.find("bearings.csv:3: bearing_deg: ends table 0"), std::string::npos);
}

}  // namespace
}  // namespace lookout::core
