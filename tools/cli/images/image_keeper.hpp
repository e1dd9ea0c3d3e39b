#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/files/image_recording.hpp"

namespace lookout::tools {

/// Writes the images of a stream into a recording directory, which it begins with the first of them. Images
/// that go back in time, as of a log that was played twice, or that repeat a sensor's time are left out and
/// counted: a recording's images are on one clock.
class ImageKeeper {
 public:
  /// @param directory of the recording; empty: nothing is written.
  explicit ImageKeeper(std::string directory) : directory_(std::move(directory)) {}

  /// Takes the next image of the stream. @throws core::InputError where the disk refuses.
  void add(const core::SonarImage& image);

  /// There is no more. @return whether there is an image in the recording.
  bool close();

  std::int64_t left_out() const { return left_out_; }  ///< Images that are not in it.

 private:
  std::string directory_;
  std::optional<core::ImageWriter> writer_;
  std::map<std::int32_t, std::int64_t> last_utime_;  ///< By sensor.
  std::int64_t newest_ = 0;
  std::int64_t left_out_ = 0;
};

}  // namespace lookout::tools
