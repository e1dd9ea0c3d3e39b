#include "core/uneven_fan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/beam_bearings.hpp"
#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::core {
namespace {

constexpr double kMostBinsPerBeam = 16.0;  // Of a fan with one very narrow beam; more would only cost memory.
constexpr double kMiddle = 0.5;            // Of two: a mean, an edge midway.

}  // namespace

UnevenFan::UnevenFan(std::vector<double> bearings) : bearings_(std::move(bearings)) {
  require(bearings_.size() >= 2 && is_beam_table(bearings_),
          "beam centres must be two or more, increase, and lie within a full turn",
          static_cast<double>(bearings_.size()));
  mean_step_ = core::mean_step(bearings_);
  left_edge_ = core::left_edge(bearings_);
  right_edge_ = core::right_edge(bearings_);
  const std::size_t last = bearings_.size() - 1;
  for (std::size_t beam = 0; beam <= last; ++beam) {
    const double to_port = beam > 0 ? bearings_[beam] - bearings_[beam - 1] : bearings_[1] - bearings_[0];
    const double to_starboard =
        beam < last ? bearings_[beam + 1] - bearings_[beam] : bearings_[last] - bearings_[last - 1];
    widths_.push_back(kMiddle * (to_port + to_starboard));
  }
  narrowest_ = *std::min_element(widths_.begin(), widths_.end());
  sort_into_bins();
}

// So many bins that few hold more than one centre.
void UnevenFan::sort_into_bins() {
  const double most = kMostBinsPerBeam * num_beams();
  const double span = bearings_.back() - bearings_.front();
  const auto bins = static_cast<std::size_t>(std::min(std::ceil(span / narrowest_) + 1.0, most));
  bins_per_radian_ = static_cast<double>(bins) / span;
  bins_.resize(bins);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double start = bearings_.front() + static_cast<double>(bin) / bins_per_radian_;
    const auto right = std::upper_bound(bearings_.begin() + 1, bearings_.end() - 1, start);
    bins_[bin] = static_cast<std::int32_t>(right - bearings_.begin()) - 1;
  }
}

double UnevenFan::width(int beam) const {
  return widths_[static_cast<std::size_t>(std::clamp(beam, 0, num_beams() - 1))];
}

double UnevenFan::place_of(double bearing) const {
  const double middle = kMiddle * (bearings_.front() + bearings_.back());
  const double offset = bearing - middle;
  const double near = std::abs(offset) <= std::numbers::pi ? bearing : middle + wrap_to_pi(offset);
  const double bin =
      std::clamp((near - bearings_.front()) * bins_per_radian_, 0.0, static_cast<double>(bins_.size() - 1));
  auto left = static_cast<std::size_t>(bins_[static_cast<std::size_t>(bin)]);
  while (left + 2 < bearings_.size() && near >= bearings_[left + 1]) ++left;
  while (left > 0 && near < bearings_[left]) --left;
  return static_cast<double>(left) + (near - bearings_[left]) / (bearings_[left + 1] - bearings_[left]);
}

double UnevenFan::bearing_at(double place) const {
  return core::bearing_at(bearings_, place);
}

int UnevenFan::beam_of(double bearing) const {
  const double beam = std::floor(place_of(bearing) + kMiddle);
  return beam >= 0.0 && beam < num_beams() ? static_cast<int>(beam) : -1;
}

bool UnevenFan::fits(int num_beams, double first_bearing, double bearing_step) const {
  const double last = first_bearing + (num_beams - 1) * bearing_step;
  return num_beams == this->num_beams() &&
         std::abs(first_bearing - bearings_.front()) <= kMiddle * mean_step_ &&
         std::abs(last - bearings_.back()) <= kMiddle * mean_step_;
}

bool same_fan(const UnevenFan* a, const UnevenFan* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a == b ||
         std::equal(a->bearings().begin(), a->bearings().end(), b->bearings().begin(), b->bearings().end());
}

}  // namespace lookout::core
