// SONAR_IMAGE -> detector -> SONAR_SCAN
#include "tracking/node/detector_node.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "lcmtypes/convert.hpp"

namespace lookout::tracking {

DetectorNode::DetectorNode(lcmtypes::Bus& bus, const std::string& channel_prefix,
                           const DetectionParams& params, Report report)
    : bus_(bus),
      channels_(channel_prefix),
      detector_(params,
                [this, report = std::move(report)](const std::string& line) {
                  last_error_ = line;
                  report(line);
                }),
      status_(bus, channels_.status(), "lookout detect", 0) {
  bus_.subscribe<sonar_image_t>(channels_.sonar_image(),
                                [this](const core::SonarImage& image) { take(image); });
}

void DetectorNode::run(const lcmtypes::LoopLimits& limits) {
  const auto publish_status = [this] {
    const std::string& damaged = bus_.inbox().last_error();
    status_.publish(figures(), damaged.empty() ? last_error_ : damaged);
  };
  lcmtypes::NodeLoop(bus_, limits, publish_status).run();
  bus_.drain();
  publish_status();
}

void DetectorNode::take(const core::SonarImage& image) {
  const auto arrival = lcmtypes::NodeLoop::Clock::now();
  const core::SonarScan* scan = detector_.detect(image);
  count_sequence(image);
  if (scan == nullptr) return;
  newest_utime_ = std::max(newest_utime_, image.utime);
  bus_.publish(channels_.sonar_scan(), lcmtypes::to_wire(*scan));
  const std::chrono::duration<double, std::milli> latency = lcmtypes::NodeLoop::Clock::now() - arrival;
  status_.add_latency(latency.count());
}

void DetectorNode::count_sequence(const core::SonarImage& image) {
  if (gaps_.size() >= StreamDetector::kMostSonars && !gaps_.contains(image.sensor_id)) return;
  core::SequenceGaps& gaps = gaps_[image.sensor_id];
  const std::int64_t before = gaps.lost();
  gaps.add(image.sequence);
  lost_ += gaps.lost() - before;
}

lcmtypes::NodeFigures DetectorNode::figures() const {
  return {newest_utime_, detector_.counts().images, detector_.damaged() + bus_.inbox().bad_messages(), lost_};
}

}  // namespace lookout::tracking
