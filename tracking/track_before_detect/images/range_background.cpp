#include "tracking/track_before_detect/images/range_background.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

double median_in_place(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

RangeBackground::RangeBackground(const RangeBackgroundParams& params) : params_(params) {
  core::require(params.half_window >= 0, "half_window must be >= 0", params.half_window);
}

const IntensityFrame& RangeBackground::normalise(const core::SonarImage& image) {
  const int bins = image.num_bins, beams = image.num_beams();
  median_.resize(static_cast<std::size_t>(bins));
  level_.resize(median_.size());
  for (int bin = 0; bin < bins; ++bin) {
    scratch_.clear();
    for (int beam = 0; beam < beams; ++beam) scratch_.push_back(image.at(beam, bin));
    median_[static_cast<std::size_t>(bin)] = median_in_place(scratch_);
  }
  for (int bin = 0; bin < bins; ++bin) {
    const int first = std::max(0, bin - params_.half_window);
    const int last = std::min(bins, bin + params_.half_window + 1);
    scratch_.assign(median_.begin() + first, median_.begin() + last);
    level_[static_cast<std::size_t>(bin)] = median_in_place(scratch_);
  }
  frame_.columns = bins;
  frame_.rows = beams;
  frame_.values.resize(image.intensity.size());
  for (std::size_t i = 0; i < frame_.values.size(); ++i) {
    const double level = level_[i % static_cast<std::size_t>(bins)];
    frame_.values[i] = level > 0.0 ? image.intensity[i] / level : 0.0;
  }
  return frame_;
}

}  // namespace lookout::tracking
