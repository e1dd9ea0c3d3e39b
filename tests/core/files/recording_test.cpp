#include "core/files/recording.hpp"

#include <gtest/gtest.h>

#include "core/files/image_recording.hpp"
#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

Recording small_recording() {
  Recording recording;
  recording.params = SonarParams{};
  for (int k = 0; k < 3; ++k) {
    SonarScan scan;
    scan.utime = 500'000L * k;
    scan.sequence = k;
    if (k != 1) scan.returns = {{0.1 * k, 10.0 + k, 1.0}, {-0.2, 1.0 / 3.0, 2.0}};
    recording.scans.push_back(scan);
    recording.vehicle.push_back({500'000L * k, {1.0 * k, 2.0, 0.5}, {0, 0}});
    recording.truth.push_back({500'000L * k, {{4, {1, 2}, {3, 4}, k == 2}}});
  }
  return recording;
}

TEST(Recording, ReadsBackWhatItWrote) {
  const tests::TemporaryDirectory folder;
  const Recording written = small_recording();
  write_recording(folder.path(), written);
  const Recording read = read_recording(folder.path());
  ASSERT_EQ(read.scans.size(), 3u);
  EXPECT_EQ(read.scans[1].returns.size(), 0u);  // an empty scan survives
  EXPECT_EQ(read.scans[2].utime, 1'000'000);
  EXPECT_EQ(read.scans[2].sequence, 2);
  EXPECT_EQ(read.scans[2].returns[1].range, 1.0 / 3.0);
  EXPECT_EQ(read.scans[2].num_beams, 90);
  EXPECT_EQ(read.vehicle[2].T_earth_body.north, 2.0);
  EXPECT_FALSE(read.truth[0].targets[0].visible);
  EXPECT_TRUE(read.truth[2].targets[0].visible);
}

TEST(Recording, SonarYamlOverridesTheDefaults) {
  const tests::TemporaryDirectory folder;
  write_recording(folder.path(), small_recording());
  folder.write("sonar.yaml", "max_range: 80\n");
  SonarParams defaults;
  defaults.max_range = 200.0;
  defaults.range_sigma = 1.0;
  const Recording read = read_recording(folder.path(), defaults);
  EXPECT_EQ(read.params->max_range, 80.0);
  EXPECT_EQ(read.params->range_sigma, 1.0);
  EXPECT_EQ(read.scans[0].max_range, 80.0);
}

TEST(Recording, ReadsBackItsClocks) {
  const tests::TemporaryDirectory folder;
  Recording written = small_recording();
  written.new_clocks = {{2, 2, 2}};  // The third of each is on another clock, on which it is earlier.
  written.scans[2].utime = written.vehicle[2].utime = written.truth[2].utime = 100'000;
  write_recording(folder.path(), written);
  const Recording read = read_recording(folder.path());
  ASSERT_EQ(read.new_clocks.size(), 1u);
  EXPECT_EQ(read.new_clocks[0].scan, 2u);
  EXPECT_EQ(read.new_clocks[0].state, 2u);
  EXPECT_EQ(read.new_clocks[0].truth, 2u);
  EXPECT_EQ(read.scans[2].utime, 100'000);
  EXPECT_THROW(read_truth(folder.file("truth.csv")), InputError);  // Who scores needs one clock.
}

TEST(Recording, WithoutVehicleTheSensorStandsAtTheOrigin) {
  const tests::TemporaryDirectory folder;
  Recording written = small_recording();
  written.is_fixed = true;
  write_recording(folder.path(), written);
  const Recording read = read_recording(folder.path());
  EXPECT_TRUE(read.is_fixed);
  ASSERT_EQ(read.vehicle.size(), 3u);
  EXPECT_EQ(read.vehicle[2].utime, 1'000'000);
  EXPECT_EQ(read.vehicle[2].T_earth_body.north, 0.0);
  EXPECT_EQ(read.notes,
            std::vector<std::string>{folder.path() + ": no vehicle.csv: a fixed sensor at the origin"});
}

TEST(Recording, OfImagesAloneHasNoScans) {
  const tests::TemporaryDirectory folder;
  write_recording(folder.path(), small_recording());
  ImageWriter(folder.path()).close();
  Recording images = small_recording();
  images.scans.clear();
  images.has_images = true;
  write_recording(folder.path(), images);
  const Recording read = read_recording(folder.path());
  EXPECT_TRUE(read.has_images);
  EXPECT_EQ(read.scans.size(), 0u);
  EXPECT_EQ(read.vehicle.size(), 3u);
  write_recording(folder.path(), small_recording());
  EXPECT_FALSE(read_recording(folder.path()).has_images);  // Of another recording, they do not stay.
}

TEST(Recording, TracksReadBack) {
  const tests::TemporaryDirectory folder;
  Track track;
  track.id = 9;
  track.status = TrackStatus::coasting;
  track.state << 1.5, 2.5, 0.25, -0.75;
  track.existence = 0.875;
  write_tracks(folder.file("tracks.csv"), {{500'000, {track}}});
  const auto lists = read_tracks(folder.file("tracks.csv"));
  ASSERT_EQ(lists.size(), 1u);
  EXPECT_EQ(lists[0].tracks[0].id, 9);
  EXPECT_EQ(lists[0].tracks[0].status, TrackStatus::coasting);
  EXPECT_EQ(lists[0].tracks[0].state, track.state);
}

TEST(Recording, BadRowsNameTheirLine) {
  const tests::TemporaryDirectory folder;
  folder.write("vehicle.csv", "time_s,north_m,east_m,heading_rad\n0,0,0,0\n");
  folder.write("scans.csv", "time_s,bearing_rad,range_m,intensity\n1,0,5,1\n0.5,0,5,1\n");
  try {
    read_recording(folder.path());
    FAIL() << "a scan that goes back in time was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find(folder.file("scans.csv") + ":3: time_s: goes back in time"), 0u);
  }
  EXPECT_THROW(read_recording(folder.file("nowhere")), InputError);
}

TEST(Recording, ACellOfAStateThatIsNoNumberIsRefused) {
  const tests::TemporaryDirectory folder;
  EXPECT_THROW(read_tracks(folder.write("t.csv", "time_s,id,north_m,east_m\n0,1,40,1x\n")), InputError);
}

TEST(Recording, UnknownStatusIsRefused) {
  const tests::TemporaryDirectory folder;
  EXPECT_THROW(read_tracks(folder.write("t.csv", "time_s,id,status,north_m,east_m\n0,1,sure,0,0\n")),
               InputError);
}

TEST(Recording, WithoutIdentitiesTheRowsOfATimeAreNumbered) {
  const tests::TemporaryDirectory folder;
  const auto path = folder.write("t.csv", "time_s,north_m,east_m\n0,1,0\n0,2,0\n1,3,0\n");
  const auto lists = read_tracks(path);
  ASSERT_EQ(lists.size(), 2U);
  EXPECT_EQ(lists[0].tracks[1].id, 2);
  EXPECT_EQ(lists[1].tracks[0].id, 1);
  EXPECT_EQ(read_truth(path)[0].targets[1].id, 2);
}

}  // namespace
}  // namespace lookout::core
