#include "tracking/metrics/truth_timeline.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "core/files/time_text.hpp"
#include "core/frames.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSameTime = 1;  // [us]

const core::TargetTruth* find_target(const core::GroundTruth& list, std::int32_t id) {
  const auto found = std::find_if(list.targets.begin(), list.targets.end(),
                                  [id](const auto& target) { return target.id == id; });
  return found != list.targets.end() ? &*found : nullptr;
}

core::TargetTruth between(const core::TargetTruth& a, const core::TargetTruth& b, double share) {
  core::TargetTruth target = share < 0.5 ? a : b;
  target.position = (1.0 - share) * a.position + share * b.position;
  target.velocity = (1.0 - share) * a.velocity + share * b.velocity;
  return target;
}

/// On a straight line from a target's state at the nearer list, over the time that lies between.
core::TargetTruth moved(core::TargetTruth target, double seconds) {
  target.position += seconds * target.velocity;
  return target;
}

core::GroundTruth interpolated(const core::GroundTruth& before, const core::GroundTruth& after,
                               std::int64_t utime) {
  const double share =
      static_cast<double>(utime - before.utime) / static_cast<double>(after.utime - before.utime);
  const core::GroundTruth& nearer = share < 0.5 ? before : after;
  core::GroundTruth truth{utime, {}};
  for (const auto& target : nearer.targets) {
    const core::TargetTruth* a = find_target(before, target.id);
    const core::TargetTruth* b = find_target(after, target.id);
    truth.targets.push_back(a != nullptr && b != nullptr
                                ? between(*a, *b, share)
                                : moved(target, core::seconds(utime - nearer.utime)));
  }
  return truth;
}

/// The distance [us] of `time` from the nearest of `times`, which are in order and not empty.
std::int64_t distance_to(const std::vector<std::int64_t>& times, std::int64_t time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  std::int64_t least = after != times.end() ? *after - time : time - times.back();
  if (after != times.begin()) least = std::min(least, time - *std::prev(after));
  return least;
}

}  // namespace

TruthTimeline::TruthTimeline(std::vector<core::GroundTruth> truth, const TruthMatch& match)
    : truth_(std::move(truth)), match_(match) {
  if (match.tolerance < 0)
    throw std::invalid_argument("time tolerance must be >= 0, got " + std::to_string(match.tolerance));
  // A log's clock may have stepped back.
  std::stable_sort(truth_.begin(), truth_.end(),
                   [](const auto& a, const auto& b) { return a.utime < b.utime; });
}

std::optional<core::GroundTruth> TruthTimeline::at(std::int64_t utime) const {
  const auto after =
      std::lower_bound(truth_.begin(), truth_.end(), utime,
                       [](const core::GroundTruth& list, std::int64_t t) { return list.utime < t; });
  const core::GroundTruth* later = after != truth_.end() ? &*after : nullptr;
  const core::GroundTruth* earlier = after != truth_.begin() ? &*std::prev(after) : nullptr;
  const core::GroundTruth* nearest = later;
  if (earlier != nullptr && (later == nullptr || utime - earlier->utime < later->utime - utime))
    nearest = earlier;
  if (nearest == nullptr) return std::nullopt;
  if (std::abs(nearest->utime - utime) <= std::max(kSameTime, match_.tolerance)) return *nearest;
  if (!match_.interpolate || earlier == nullptr || later == nullptr) return std::nullopt;
  if (later->utime - earlier->utime > kLongestGap) return std::nullopt;
  return interpolated(*earlier, *later, utime);
}

TimeAgreement compare_times(const std::vector<std::int64_t>& truth, const std::vector<std::int64_t>& others) {
  TimeAgreement agreement;
  if (truth.empty() || others.empty()) return agreement;
  agreement.apart =
      truth.back() < others.front() - kClockSlack || others.back() < truth.front() - kClockSlack;
  agreement.nearest = distance_to(truth, others.front());
  for (const std::int64_t time : others) {
    const std::int64_t distance = distance_to(truth, time);
    agreement.nearest = std::min(agreement.nearest, distance);
    if (time < truth.front() - kClockSlack || time > truth.back() + kClockSlack) continue;
    ++agreement.shared;
    if (distance <= kSameTime) ++agreement.matched;
    if (distance <= kClockSlack) ++agreement.near;
  }
  return agreement;
}

ChosenMatch choose_match(const std::vector<std::int64_t>& truth, const std::vector<std::int64_t>& scans) {
  const TimeAgreement agreement = compare_times(truth, scans);
  // Half of them: a truth without rows while there is no target is still on the scans' times.
  if (agreement.shared == 0 || 2 * agreement.matched >= agreement.shared) return {};
  const std::string what = std::to_string(agreement.matched) + " of " + std::to_string(agreement.shared) +
                           " scans are at a time of the truth (the nearest is " +
                           core::time_text(agreement.nearest) + " s off): truth taken within " +
                           core::time_text(kClockSlack) + " s";
  if (agreement.near == agreement.shared) return {{kClockSlack, false}, what};
  return {{kClockSlack, true}, what + ", else interpolated"};
}

}  // namespace lookout::tracking
