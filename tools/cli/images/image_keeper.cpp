#include "tools/cli/images/image_keeper.hpp"

#include <utility>

namespace lookout::tools {

void ImageKeeper::add(const core::SonarImage& image) {
  if (directory_.empty()) return;
  const auto last = last_utime_.find(image.sensor_id);
  const bool repeats = last != last_utime_.end() && image.utime <= last->second;
  if (writer_ && (repeats || image.utime < newest_)) {
    ++left_out_;
    return;
  }
  if (!writer_) writer_.emplace(directory_);
  writer_->add(image);
  newest_ = last_utime_[image.sensor_id] = image.utime;
}

bool ImageKeeper::close() {
  if (writer_) writer_->close();
  return writer_.has_value();
}

}  // namespace lookout::tools
