#include "sonar_sim/image/image_section.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

namespace lookout::sonar_sim {
namespace {

std::string scene_with(const std::string& image, const std::string& sea = "") {
  std::string text =
      "duration: 1\nsonar: {scan_period: 0.5, miss_probability: 0.1, false_alarm_probability: 0.1}\n";
  return text.append(sea).append("image: {").append(image).append("}\n");
}

std::string error_of(const std::string& image) {
  try {
    parse_scene(scene_with(image), "scene");
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ImageSection, OffByDefault) {
  const Scene scene = parse_scene(scene_with(""), "scene");
  const ImageSeaPlan& sea = scene.platforms[0].image->sea;
  EXPECT_FALSE(sea.correlated_speckle || sea.gain_stripes || sea.bottom || sea.standing_snr_db ||
               sea.shadows || sea.fluctuation);
  EXPECT_EQ(scene.platforms[0].image->bits, 16);
}

TEST(ImageSection, ReadsEveryPart) {
  const Scene scene = parse_scene(
      scene_with(
          "bits: 8, beam_taper: hann, speckle: point_spread, gain_stripes: {depth_db: 6, width_beams: 4}, "
          "bottom: {range: 30, level_db: 12, extent: 9}, standing_snr_db: 20, "
          "shadows: {depth_db: 15, length: 8}, fluctuation: {swerling: 3, dwell: 1.5}",
          "sea: {standing: {points: [{north: 20, east: 3}]}}\n"),
      "scene");
  const ImagePlan& image = *scene.platforms[0].image;
  EXPECT_EQ(image.bits, 8);
  EXPECT_TRUE(image.tapered && image.sea.correlated_speckle);
  EXPECT_EQ(image.sea.gain_stripes->width_beams, 4);
  EXPECT_EQ(image.sea.bottom->extent, 9.0);
  EXPECT_EQ(image.sea.standing_snr_db, 20.0);
  EXPECT_EQ(image.sea.shadows->length, 8.0);
  EXPECT_EQ(image.sea.fluctuation->dwell, 1.5);
}

TEST(ImageSection, RefusesWhatWouldDoNothingOrDoesNotFit) {
  EXPECT_NE(error_of("standing_snr_db: 20").find("of which the scene has none"), std::string::npos);
  EXPECT_NE(error_of("shadows: {depth_db: 3}").find("expected standing_snr_db too"), std::string::npos);
  EXPECT_NE(error_of("fluctuation: {swerling: 2, dwell: 1}").find("draws at every ping"), std::string::npos);
  EXPECT_NE(error_of("num_bins: 30000, bits: 17").find("bits"), std::string::npos);
  EXPECT_NE(error_of("speckle: some").find("point_spread"), std::string::npos);
}

TEST(ImageSection, RefusesMorePixelsThanAMessageTakes) {
  const std::string scene =
      "duration: 1\nsonar: {num_beams: 512, first_bearing_deg: -60, bearing_step_deg: 0.234, scan_period: "
      "0.5, "
      "miss_probability: 0.1, false_alarm_probability: 0.1}\nimage: {num_bins: 8193}\n";
  EXPECT_THROW(parse_scene(scene, "scene"), core::InputError);
}

}  // namespace
}  // namespace lookout::sonar_sim
