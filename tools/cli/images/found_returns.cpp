#include "tools/cli/images/found_returns.hpp"

#include "tools/cli/log.hpp"

namespace lookout::tools {

FoundReturns::FoundReturns(const Configuration& configuration)
    : detector_(configuration.detection, [](const std::string& line) { log_warning("detect: " + line); }) {}

void FoundReturns::add(const core::SonarImage& image) {
  ++counts_.received;
  const core::SonarScan* scan = detector_.detect(image);
  counts_.damaged = detector_.damaged();
  if (scan == nullptr) return;
  ++counts_.accepted;
  if (on_scan_) on_scan_(*scan);
}

void FoundReturns::start_new_clock() {
  ends_.push_back(static_cast<std::size_t>(counts_.accepted));
}

const tracking::ImageDetector* FoundReturns::detector() const {
  return counts_.accepted == 0 ? nullptr : &detector_.detector();
}

}  // namespace lookout::tools
