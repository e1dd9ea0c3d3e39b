// One file of a recording, the others whole: the first letter names it. What is read can be written and is
// then read again.
#include <filesystem>
#include <map>

#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"
#include "tests/fuzz/fuzz_support.hpp"

namespace lookout::tests {
namespace {

const std::map<char, std::string> kFiles{{'s', "scans.csv"},  {'v', "vehicle.csv"},  {'t', "truth.csv"},
                                         {'y', "sonar.yaml"}, {'g', "geometry.csv"}, {'k', "tracks.csv"},
                                         {'i', "images.csv"}, {'b', "bearings.csv"}};

core::SonarImage small_image() {
  core::SonarImage image;
  image.bearings = {-0.1, 0.0, 0.2};
  image.range_step = 0.5;
  image.num_bins = 2;
  image.intensity = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  return image;
}

core::Recording small_recording() {
  core::Recording recording;
  recording.params = core::SonarParams{};
  recording.has_images = true;
  for (std::int64_t k = 0; k < 3; ++k) {
    core::SonarScan scan;
    scan.utime = 500'000 * k;
    scan.sequence = k;
    scan.returns = {{0.1 * static_cast<double>(k), 10.0, 1.0}, {-0.2, 1.0 / 3.0, 2.0}};
    recording.scans.push_back(scan);
    recording.vehicle.push_back({500'000 * k, {static_cast<double>(k), 2.0, 0.5}, {0, 0}});
    recording.truth.push_back({500'000 * k, {{4, {1, 2}, {3, 4}, k == 2}}});
  }
  return recording;
}

/// Every file whole.
std::string whole_recording() {
  std::string folder = scratch().file("recording");
  core::ImageWriter images(folder);
  images.add(small_image());
  images.close();
  core::write_recording(folder, small_recording());
  core::write_tracks(folder + "/tracks.csv", {{0, {core::Track{}}}, {500'000, {core::Track{}}}});
  return folder;
}

void read(const std::string& folder) {
  const core::Recording recording = core::read_recording(folder);
  core::write_recording(scratch().file("again"), recording);
  const core::Recording again = core::read_recording(scratch().file("again"));
  require(again.scans.size() == recording.scans.size() && again.vehicle.size() == recording.vehicle.size() &&
          again.truth.size() == recording.truth.size());
}

void read_images(const std::string& folder) {
  const core::ImageReader images(folder);
  for (std::size_t i = 0; i < images.size(); ++i) images.read(i);
}

void read_file(char which, const std::string& folder) {
  if (which == 'k') read_or_refuse([&] { core::read_tracks(folder + "/tracks.csv"); });
  if (which == 'k') return;
  read_or_refuse([&] { read(folder); });
  if (which == 'i' || which == 'b') read_or_refuse([&] { read_images(folder); });
}

}  // namespace
}  // namespace lookout::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout::tests;
  static const std::string folder = whole_recording();
  const auto file = size > 0 ? kFiles.find(static_cast<char>(*data)) : kFiles.end();
  if (file == kFiles.end()) return 0;
  const std::string name = "recording/" + file->second, kept = scratch().file(name + ".kept");
  const bool was_there = std::filesystem::exists(scratch().file(name));
  if (was_there) std::filesystem::rename(scratch().file(name), kept);
  write_scratch(name, as_text(data + 1, size - 1));
  read_file(file->first, folder);
  std::filesystem::remove(scratch().file(name));
  if (was_there) std::filesystem::rename(kept, scratch().file(name));
  return 0;
}
