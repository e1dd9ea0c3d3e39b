#include "core/files/grey_image.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string error_of(const std::string& path) {
  try {
    read_pgm(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GreyImage, RoundTripOfSixteenBits) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write_pgm(path, {3, 2, {0, 1, 255, 256, 65535, 70000}});
  const GreyImage image = read_pgm(path);
  EXPECT_EQ(image.columns, 3);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.pixels,
            (std::vector<double>{0, 1, 255, 256, 65535, 65535}));  // most significant byte first
}

TEST(GreyImage, AnotherWhiteLeavesTheValues) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("a.pgm");
  write_pgm(path, {2, 1, {7, 300}}, 300);
  EXPECT_EQ(read_pgm(path).pixels, (std::vector<double>{7, 300}));
  std::string magic, columns, rows, white;
  std::ifstream(path) >> magic >> columns >> rows >> white;
  EXPECT_EQ(white, "300");
}

TEST(GreyImage, ReadsEightBitsPlainTextAndComments) {
  const tests::TemporaryDirectory directory;
  write(directory.path() + "/a.pgm", "P5 # made by hand\n2 1\n255\n\x05\x07");
  EXPECT_EQ(read_pgm(directory.path() + "/a.pgm").pixels, (std::vector<double>{5, 7}));
  write(directory.path() + "/b.pgm", "P2\n2 1\n300\n12 299\n");
  EXPECT_EQ(read_pgm(directory.path() + "/b.pgm").pixels, (std::vector<double>{12, 299}));
}

TEST(GreyImage, AHeaderInLinesOfCrLfIsNoPixel) {
  const tests::TemporaryDirectory directory;
  write(directory.file("a.pgm"), "P5\r\n2 1\r\n255\r\n\x05\x07");
  EXPECT_EQ(read_pgm(directory.file("a.pgm")).pixels, (std::vector<double>{5, 7}));
  write(directory.file("b.pgm"), "P5\r\n2 1\r\n255\r\x0a\x07");  // Ended by CR: the first pixel is 10.
  EXPECT_EQ(read_pgm(directory.file("b.pgm")).pixels, (std::vector<double>{10, 7}));
}

// Weights of [Pakfiliz2018] Eq. (1): red 255 is 76.2, and a grey colour its own level within their sum,
// .9999.
TEST(GreyImage, ColoursBecomeGrey) {
  const tests::TemporaryDirectory directory;
  write(directory.path() + "/a.ppm",
        "P6\n2 1\n255\n\xff\x01\x02"
        "ddd");
  const std::vector<double> binary = read_picture(directory.path() + "/a.ppm").pixels;
  ASSERT_EQ(binary.size(), 2u);
  EXPECT_NEAR(binary[0], 0.2989 * 255 + 0.587 * 1 + 0.114 * 2, 1e-9);
  EXPECT_NEAR(binary[1], 100.0, 0.02);
  write(directory.path() + "/b.ppm", "P3\n1 1\n300\n300 0 10\n");
  EXPECT_NEAR(read_picture(directory.path() + "/b.ppm").pixels.at(0), 0.2989 * 300 + 0.114 * 10, 1e-9);
  write(directory.path() + "/c.pgm", "P5\n2 1\n255\n\x05\x07");
  EXPECT_EQ(read_picture(directory.path() + "/c.pgm").pixels, (std::vector<double>{5, 7}));
}

TEST(GreyImage, ACutOffColourPictureSaysHowManyPixelsItHolds) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.ppm";
  write(path, "P6\n2 2\n255\nabcdefg");
  try {
    read_picture(path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), path + ": is truncated: holds 2 of 4 pixels");
  }
  EXPECT_NE(error_of(path).find("is not a PGM"), std::string::npos);  // where only grey is taken
}

TEST(GreyImage, ATruncatedFileSaysHowMuchItHolds) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write(path, "P5\n4 4\n65535\n123456");
  EXPECT_EQ(error_of(path), path + ": is truncated: holds 3 of 16 pixels");
}

TEST(GreyImage, RefusesOtherFilesAndBadHeaders) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write(path, "hello");
  EXPECT_NE(error_of(path).find("is not a PGM"), std::string::npos);
  write(path, "P5\n0 4\n255\n");
  EXPECT_NE(error_of(path).find("bad width"), std::string::npos);
  write(path, "P5\n4 4\n99999999999999\n");
  EXPECT_NE(error_of(path).find("bad maximum value"), std::string::npos);
  EXPECT_NE(error_of(directory.path() + "/none.pgm").find("cannot be read"), std::string::npos);
}

TEST(GreyImage, TooManyPixelsAreRefused) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write(path, "P5\n30000 30000\n255\n");
  EXPECT_NE(error_of(path).find("has 900000000 pixels"), std::string::npos);
}

}  // namespace
}  // namespace lookout::core
