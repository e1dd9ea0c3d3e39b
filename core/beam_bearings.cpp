#include "core/beam_bearings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/frames.hpp"

namespace lookout::core {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kRounding = 1e-9;  // of a full turn in steps of degrees

/// The beam at the left of a place, so that there is another at its right; of tables of two beams and more.
std::size_t left_beam(std::span<const double> bearings, double place) {
  const auto last = static_cast<double>(bearings.size() - 2);
  return static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
}

}  // namespace

std::vector<double> even_bearings(double first_bearing, double step, int num_beams) {
  std::vector<double> bearings;
  bearings.reserve(static_cast<std::size_t>(std::max(0, num_beams)));
  for (int beam = 0; beam < num_beams; ++beam) bearings.push_back(first_bearing + beam * step);
  return bearings;
}

bool is_beam_table(std::span<const double> bearings) {
  if (bearings.empty()) return false;
  for (const double bearing : bearings)
    if (!std::isfinite(bearing)) return false;
  const auto falls = [](double a, double b) { return !(b > a); };
  if (std::adjacent_find(bearings.begin(), bearings.end(), falls) != bearings.end()) return false;
  return right_edge(bearings) - left_edge(bearings) <= kTurn * (1.0 + kRounding);
}

double mean_step(std::span<const double> bearings) {
  if (bearings.size() < 2) return kSingleBeamStep;
  return (bearings.back() - bearings.front()) / static_cast<double>(bearings.size() - 1);
}

double step_at(std::span<const double> bearings, double place) {
  if (bearings.size() < 2) return kSingleBeamStep;
  const std::size_t left = left_beam(bearings, place);
  return bearings[left + 1] - bearings[left];
}

double bearing_at(std::span<const double> bearings, double place) {
  if (bearings.size() < 2) return bearings.front() + place * kSingleBeamStep;
  const std::size_t left = left_beam(bearings, place);
  return bearings[left] + (place - static_cast<double>(left)) * (bearings[left + 1] - bearings[left]);
}

double place_of(std::span<const double> bearings, double bearing) {
  const double middle = 0.5 * (bearings.front() + bearings.back());
  const double near = middle + wrap_to_pi(bearing - middle);
  if (bearings.size() < 2) return (near - bearings.front()) / kSingleBeamStep;
  const auto right = std::upper_bound(bearings.begin() + 1, bearings.end() - 1, near);
  const auto left = static_cast<std::size_t>(right - bearings.begin()) - 1;
  return static_cast<double>(left) + (near - bearings[left]) / (bearings[left + 1] - bearings[left]);
}

double left_edge(std::span<const double> bearings) {
  return bearing_at(bearings, -0.5);
}

double right_edge(std::span<const double> bearings) {
  return bearing_at(bearings, static_cast<double>(bearings.size()) - 0.5);
}

}  // namespace lookout::core
