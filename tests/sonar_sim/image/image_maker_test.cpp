#include "sonar_sim/image/image_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/beam_bearings.hpp"
#include "sonar_sim/sonar_simulator.hpp"

namespace lookout::sonar_sim {
namespace {

/// A scene of a few pings with an image of these keys and a sea of those.
Scene scene_of(const std::string& image, const std::string& sea = "", const std::string& targets = "") {
  std::string text =
      "duration: 2.0\nvehicle: {north_velocity: 1.5, yaw_swing_deg: 8.0, yaw_period: 4.0}\n"
      "sonar: {miss_probability: 0.3, false_alarm_probability: 0.1}\nimage: {";
  return parse_scene(text.append(image).append("}\n").append(sea).append(targets), "scene");
}

std::vector<core::SonarImage> images_of(const Scene& scene, std::uint64_t seed) {
  SonarSimulator simulator(scene, seed);
  std::vector<core::SonarImage> images;
  while (const auto ping = simulator.next()) images.push_back(*ping->image);
  return images;
}

/// Root of the mean power of some beams and bins over the images.
double level(const std::vector<core::SonarImage>& images, std::pair<int, int> beams,
             std::pair<int, int> bins) {
  double power = 0.0;
  int cells = 0;
  for (const auto& image : images)
    for (int beam = beams.first; beam < beams.second; ++beam)
      for (int bin = bins.first; bin < bins.second; ++bin, ++cells) power += std::pow(image.at(beam, bin), 2);
  return std::sqrt(power / cells);
}

constexpr std::pair<int, int> kAllBeams{0, 90};

TEST(ImageMaker, AStrongTargetIsTheBrightestCellWhereItIsSeen) {
  const Scene scene = scene_of("snr_db: 40.0", "", "targets: [{id: 7, north: 60.0, east: 10.0}]\n");
  SonarSimulator simulator(scene, 1000);
  int pings = 0;
  while (const auto ping = simulator.next()) {
    const core::SonarImage& image = *ping->image;
    EXPECT_EQ(image.sequence, pings++);
    EXPECT_EQ(image.utime, ping->scan.utime);
    const auto cell =
        std::max_element(image.intensity.begin(), image.intensity.end()) - image.intensity.begin();
    const Eigen::Vector2d p_sonar =
        core::inverse_transform(ping->T_earth_sonar, ping->truth.targets[0].position);
    const double bearing = image.bearings[static_cast<std::size_t>(cell / image.num_bins)];
    EXPECT_NEAR(bearing, std::atan2(p_sonar.y(), p_sonar.x()), 0.6 * core::mean_step(image.bearings));
    EXPECT_NEAR(image.first_range + static_cast<double>(cell % image.num_bins) * image.range_step,
                p_sonar.norm(), 0.6 * image.range_step);
  }
  EXPECT_EQ(pings, 4);
}

TEST(ImageMaker, ImagesLeaveTheScansAsTheyWere) {
  const Scene with = scene_of("snr_db: 8.0, gain_stripes: {}, speckle: point_spread", "",
                              "targets: [{id: 7, north: 60.0, east: 10.0}]\n");
  Scene without = with;
  without.platforms[0].image.reset();
  SonarSimulator a(with, 1000), b(without, 1000);
  while (const auto ping = a.next()) {
    const auto plain = b.next();
    EXPECT_FALSE(plain->image.has_value());
    ASSERT_EQ(ping->scan.returns.size(), plain->scan.returns.size());
    for (std::size_t i = 0; i < plain->scan.returns.size(); ++i)
      EXPECT_EQ(ping->scan.returns[i].range, plain->scan.returns[i].range);
  }
}

TEST(ImageMaker, TheSeedAloneGivesTheImages) {
  const Scene scene = scene_of("gain_stripes: {}, speckle: point_spread, fluctuation: {swerling: 2}");
  EXPECT_EQ(images_of(scene, 1000)[3].intensity, images_of(scene, 1000)[3].intensity);
  EXPECT_NE(images_of(scene, 1000)[3].intensity, images_of(scene, 1001)[3].intensity);
}

TEST(ImageMaker, TheLevelFollowsTheRange) {
  const Scene scene = scene_of("");
  const ImagePlan& plan = *scene.platforms[0].image;
  const auto images = images_of(scene, 1002);
  for (const int bin : {10, 100, 250}) {
    const double range = plan.first_range + (bin + 4.5) * plan.range_step;
    EXPECT_NEAR(level(images, kAllBeams, {bin, bin + 10}) / plan.background_level(range), 1.0, 0.06) << bin;
  }
}

TEST(ImageMaker, HoldsWholeStepsOfItsBits) {
  for (const auto& [keys, levels] : {std::pair("bits: 8", 255.0), std::pair("bits: 16", 32767.0)}) {
    const core::SonarImage image = images_of(scene_of(keys), 1003).front();
    EXPECT_NEAR(core::largest_magnitude(image) / image.intensity_scale, levels, 1e-6);
    for (const double value : image.intensity) {
      const double steps = value / image.intensity_scale;
      ASSERT_NEAR(steps, std::round(steps), 1e-6);
    }
  }
}

TEST(ImageMaker, StripesAreTheSameAtEveryPing) {
  const auto plain = images_of(scene_of("background: rayleigh"), 1004);
  const auto striped = images_of(scene_of("background: rayleigh, gain_stripes: {depth_db: 10}"), 1004);
  double least = 1e9, largest = 0.0;
  for (int beam = 0; beam < 90; ++beam) {
    const double gain =
        level({striped[0]}, {beam, beam + 1}, {0, 300}) / level({plain[0]}, {beam, beam + 1}, {0, 300});
    const double later =
        level({striped[3]}, {beam, beam + 1}, {0, 300}) / level({plain[3]}, {beam, beam + 1}, {0, 300});
    EXPECT_NEAR(gain / later, 1.0, 1e-3);  // The same draws behind another gain.
    least = std::min(least, gain), largest = std::max(largest, gain);
  }
  const double depth_db = 20.0 * std::log10(largest / least);
  EXPECT_LT(depth_db, 10.05);
  EXPECT_GT(depth_db, 9.0);  // The extremes of 90 uniform draws.
}

TEST(ImageMaker, TheBottomRaisesTheBackgroundBehindItsRange) {
  const auto images = images_of(
      scene_of("background: rayleigh, reverberation_level: 0, bottom: {range: 60, level_db: 15, extent: 20}"),
      1005);
  EXPECT_NEAR(level(images, kAllBeams, {20, 119}), 1.0, 0.02);  // To 59.5 m.
  // 15 dB over 1, with a tenth of the extent behind: hypot(1, 5.62 exp(-.1)) = 5.18.
  EXPECT_NEAR(level(images, kAllBeams, {123, 125}), 5.18, 0.15);
}

TEST(ImageMaker, StandingThingsAreSeenAndCastShadows) {
  const std::string sea = "sea: {standing: {lines: [{from: [40, -60], to: [40, 60]}]}}\n";
  // Tapered, so that the wall abeam, which is farther, is not heard ahead.
  const std::string keys = "background: rayleigh, reverberation_level: 0, beam_taper: hann";
  Scene scene = scene_of(std::string(keys).append(", standing_snr_db: 20, shadows: {depth_db: 20}"), sea);
  scene.platforms[0].vehicle = {};  // At rest, so that the wall stays in its bin ahead.
  const auto images = images_of(scene, 1006);
  // 20 dB of the wall beside the background's 1, in the bin of 40 m; three scatterers of random phase a beam.
  EXPECT_GT(level(images, {40, 50}, {79, 81}), 5.0);
  EXPECT_NEAR(level(images, {40, 50}, {20, 70}), 1.0, 0.05);
  EXPECT_NEAR(level(images, {40, 50}, {95, 300}), 0.1, 0.005);
  EXPECT_NEAR(level(images_of(scene_of(keys, sea), 1006), {40, 50}, {79, 81}), 1.0,
              0.2);  // Unseen unless asked for.
}

TEST(ImageMaker, TargetsFluctuate) {
  const std::string targets = "targets: [{id: 7, north: 60.0, east: 0.0, snr_db: 40.0}]\n";
  const auto peak = [](const core::SonarImage& image) { return core::largest_magnitude(image); };
  const auto steady = images_of(scene_of("", "", targets), 1007);
  const auto fast = images_of(scene_of("fluctuation: {swerling: 2}", "", targets), 1007);
  double least = 1e9, largest = 0.0;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    const double factor = peak(fast[i]) / peak(steady[i]);
    least = std::min(least, factor), largest = std::max(largest, factor);
  }
  EXPECT_GT(largest / least, 1.1);
}

TEST(ImageMaker, UnevenBeamsAreThoseOfTheSonar) {
  const Scene scene = parse_scene(
      "duration: 0.5\nsonar: {beam_bearings_deg: [-20, -8, 0, 3, 30], miss_probability: 0.3, "
      "false_alarm_probability: 0.1}\nimage: {beam_null_deg: 3}\n"
      "targets: [{id: 1, north: 60.0, east: 3.1, snr_db: 40.0}]\n",  // At 2.96 degrees.
      "scene");
  const core::SonarImage image = images_of(scene, 1008).front();
  ASSERT_EQ(image.num_beams(), 5);
  EXPECT_NEAR(core::degrees(image.bearings[3]), 3.0, 1e-12);
  const auto cell =
      std::max_element(image.intensity.begin(), image.intensity.end()) - image.intensity.begin();
  EXPECT_EQ(cell / image.num_bins, 3);
}

}  // namespace
}  // namespace lookout::sonar_sim
