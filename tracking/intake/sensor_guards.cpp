#include "tracking/intake/sensor_guards.hpp"

#include <algorithm>
#include <utility>

#include "core/files/csv.hpp"
#include "core/files/time_text.hpp"
#include "tracking/intake/crowded_scan.hpp"
#include "tracking/intake/intake_words.hpp"
#include "tracking/intake/ping_content.hpp"

namespace lookout::tracking {
namespace {

void give_fan(FanFinder& finder, const core::SonarParams& configured, core::SonarScan& scan) {
  scan.fan = finder.fan_of(scan, configured);
}
void give_fan(FanFinder& /*finder*/, const core::SonarParams& /*configured*/, core::SonarImage& /*image*/) {}

bool learns_fan(FanFinder& finder, const core::SonarScan& scan) {
  return finder.learn(scan);
}
bool learns_fan(FanFinder& /*finder*/, const core::SonarImage& /*image*/) {
  return false;
}

UnitGuard::Ranges ranges_of(const core::SonarScan& scan, const DroppedReturns& dropped) {
  UnitGuard::Ranges ranges;
  ranges.all = static_cast<int>(scan.returns.size()) + dropped.out_of_bounds;
  ranges.outside = dropped.out_of_bounds;
  for (const core::SonarReturn& one : scan.returns) ranges.farthest = std::max(ranges.farthest, one.range);
  ranges.maximum = scan.max_range;
  return ranges;
}
UnitGuard::Ranges ranges_of(const core::SonarImage& /*image*/, const DroppedReturns& /*dropped*/) {
  return {};
}

/// A ring-down is sharper than this share of the maximum range, whatever range_sigma says.
constexpr double kSharpShare = 0.02;

}  // namespace

bool SensorGuards::is_foreign(std::int64_t sequence, std::int64_t utime) {
  const Heard ping{sequence, utime};
  const auto end = heard_.begin() + static_cast<std::ptrdiff_t>(std::min(num_heard_, kRemembered));
  if (std::find(heard_.begin(), end, ping) != end) return false;
  heard_[num_heard_++ % kRemembered] = ping;
  return sender_.is_foreign(sequence);
}

void SensorGuards::number_comes(std::int64_t sequence) {
  using Step = core::SequenceGaps::Step;
  IntakeCounts& counts = ledger_->counts;
  const std::int64_t lost = gaps_.lost(), restarts = gaps_.restarts();
  const Step step = gaps_.add(sequence);
  counts.lost += gaps_.lost() - lost;
  counts.restarts += gaps_.restarts() - restarts;
  if (step == Step::restart) ++counts.backwards;
  if (step == Step::gap && worth_a_line(++ledger_->gaps))
    ledger_->report("lost before sequence " + std::to_string(sequence) + so_far(counts.lost));
  if (step == Step::restart && worth_a_line(counts.restarts))
    ledger_->report("sequence starts again at " + std::to_string(sequence) + so_far(counts.restarts));
}

void SensorGuards::number_is_refused(std::int64_t sequence) {
  const std::int64_t lost = gaps_.lost();
  gaps_.refused(sequence);
  ledger_->counts.lost += gaps_.lost() - lost;
}

template <class Ping>
void SensorGuards::look_at(const Ping& ping) {
  const PingGeometry geometry = geometry_of(ping);
  const bool is_new = !geometry_ || !same(*geometry_, geometry);
  const bool is_other = !agrees(ping, *configured_);
  if (is_other) ++ledger_->counts.other_geometry;
  if (is_new && is_other && (++changes_ <= kChangesTold || worth_a_line(changes_)))
    ledger_->report(described(ping) + " has another geometry than the configuration; the message wins" +
                    so_far(ledger_->counts.other_geometry));
  geometry_ = geometry;
}

template <class Ping>
void SensorGuards::watch_pace(const Ping& ping) {
  const UnitGuard::Pace pace = units_.judge_pace(ping.utime);
  if (pace == UnitGuard::Pace::plausible || !worth_a_line(++ledger_->counts.off_pace)) return;
  const char* what =
      pace == UnitGuard::Pace::too_fast ? " s, faster than a sonar can ping" : " s, far from its scan_period";
  ledger_->report(described(ping) + " follows the one before after " + core::time_text(units_.step()) + what +
                  ": stamps in another unit? utime counts microseconds, time_s seconds" +
                  so_far(ledger_->counts.off_pace));
}

template <class Ping>
bool SensorGuards::is_frozen(const Ping& ping) {
  const std::size_t content = hash_of(content_of(ping));
  const bool repeats = content != 0 && content == std::exchange(content_, content);
  if (repeats && worth_a_line(++ledger_->counts.repeated))
    ledger_->report(described(ping) + " repeats the one before to the bit: is the sensor frozen?" +
                    so_far(ledger_->counts.repeated));
  repeats_ = repeats ? repeats_ + 1 : 0;
  // A message that came twice under another stamp is no chance either.
  const auto known = heard_.begin() + static_cast<std::ptrdiff_t>(std::min(num_heard_, kRemembered));
  const bool doubled = repeats && std::any_of(heard_.begin(), known, [&ping](const Heard& other) {
                         return other.utime < ping.utime && ping.utime - other.utime < UnitGuard::kFastest;
                       });
  return repeats_ > 1 || doubled;
}

template <class Ping>
void SensorGuards::watch_ranges(const Ping& ping) {
  const SameRange same = same_range(ping);
  if (same.count > 0 && worth_a_line(++same_ranges_))
    ledger_->report(described(ping) + ": " + std::to_string(same.count) + " returns have one range, " +
                    core::shortest(same.range) +
                    " m: does it stand for silence? inf, NaN or no return says that" + so_far(same_ranges_));
}

template <class Ping>
DroppedReturns SensorGuards::drop_returns_of(Ping& ping) {
  give_fan(fan_, *configured_, ping);
  const DroppedReturns dropped = drop_returns(ping);
  watch_ranges(ping);
  if (const std::string doubt = units_.doubt_ranges(ranges_of(ping, dropped)); !doubt.empty())
    ledger_->report(described(ping) + ": " + doubt);
  if (learns_fan(fan_, ping))
    ledger_->report(described(ping) +
                    ": beams are even in sine, not in angle; they are taken at their bearings");
  return dropped;
}

template <class Ping>
void SensorGuards::leave_out(Ping& ping) {
  IntakeCounts& counts = ledger_->counts;
  const double sharp = std::min(configured_->range_sigma, kSharpShare * geometry_of(ping).max_range);
  const std::int64_t ringing = ring_.drop(ping, sharp);
  const std::size_t most = most_returns(configured_->scan_period);
  const std::int64_t shed = thin_out(ping, most);
  counts.ringing_returns += ringing;
  counts.shed_returns += shed;
  if (!configured_->point_sensor()) counts.returns_behind += returns_behind(ping, beams_heard_);
  if (ringing > 0 && worth_a_line(++counts.ringing))
    ledger_->report(described(ping) + ": " + std::to_string(ringing) +
                    " returns are the transducer's ring-down and left out" + so_far(counts.ringing));
  if (shed > 0 && worth_a_line(++counts.crowded))
    ledger_->report(described(ping) + " holds more than " + std::to_string(most) + " returns, " +
                    std::to_string(shed) + " are left out" + so_far(counts.crowded));
}

std::string_view SensorGuards::contradiction(const DroppedReturns& dropped, int all, std::int64_t utime) {
  if (!outside_.contradict(dropped.out_of_bounds, all, utime)) return {};
  return "most of its returns suddenly lie outside of its beams or range: degrees, another unit?";
}

void SensorGuards::begin_new_clock() {
  gaps_.forget();
  units_.begin_new_clock();
  content_ = 0;
  repeats_ = 0;
}

template void SensorGuards::watch_pace(const core::SonarScan& ping);
template void SensorGuards::watch_pace(const core::SonarImage& ping);
template void SensorGuards::look_at(const core::SonarScan& ping);
template void SensorGuards::look_at(const core::SonarImage& ping);
template bool SensorGuards::is_frozen(const core::SonarScan& ping);
template bool SensorGuards::is_frozen(const core::SonarImage& ping);
template void SensorGuards::leave_out(core::SonarScan& ping);
template void SensorGuards::leave_out(core::SonarImage& ping);
template DroppedReturns SensorGuards::drop_returns_of(core::SonarScan& ping);
template DroppedReturns SensorGuards::drop_returns_of(core::SonarImage& ping);

}  // namespace lookout::tracking
