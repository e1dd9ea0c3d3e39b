#include "tools/cli/recorder.hpp"

#include <algorithm>
#include <utility>

#include "core/field_of_view.hpp"

namespace lookout::tools {
namespace {

/// How far lists of truth may cross one another [us]; one that goes back farther is of the next clock.
constexpr std::int64_t kTruthCrosses = 1'000'000;

/// Where an entry of a time stands, or would.
template <class Entry>
auto place_of(std::vector<Entry>& entries, std::int64_t utime) {
  return std::lower_bound(entries.begin(), entries.end(), utime,
                          [](const Entry& other, std::int64_t time) { return other.utime < time; });
}

/// Puts an entry at its time; one at the time of another replaces it.
template <class Entry>
void put_in_order(std::vector<Entry>& entries, Entry entry) {
  const auto place = place_of(entries, entry.utime);
  if (place != entries.end() && place->utime == entry.utime)
    *place = std::move(entry);
  else
    entries.insert(place, std::move(entry));
}

/// The states, and at the time of each scan the pose that it had.
std::vector<core::VehicleState> with_poses(std::vector<core::VehicleState> states,
                                           const std::vector<core::SonarScan>& scans,
                                           const std::vector<core::Pose2>& poses) {
  std::vector<core::VehicleState> all;
  for (std::size_t i = 0; i < scans.size(); ++i) all.push_back({scans[i].utime, poses[i], {0.0, 0.0}});
  all.insert(all.end(), states.begin(), states.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.utime < b.utime; });
  const auto same_time = [](const auto& a, const auto& b) { return a.utime == b.utime; };
  all.erase(std::unique(all.begin(), all.end(), same_time), all.end());
  return all;
}

bool same(const core::Pose2& a, const core::Pose2& b) {
  return a.north == b.north && a.east == b.east && a.heading == b.heading;
}

/// Whether the states, in their order, give each scan the pose that it had to the bit.
bool give_the_poses(const std::vector<core::VehicleState>& states, const std::vector<core::SonarScan>& scans,
                    const std::vector<core::Pose2>& poses, std::int64_t max_pose_gap) {
  core::PoseHistory history(max_pose_gap);
  auto state = states.begin();
  for (std::size_t i = 0; i < scans.size(); ++i) {
    while (state != states.end() && !history.reaches(scans[i].utime)) history.add(*state++);
    const auto pose = history.at(scans[i].utime);
    if (!pose || !same(*pose, poses[i])) return false;
  }
  return true;
}

}  // namespace

Recorder::Recorder(const core::SonarParams& configured)
    : configured_(configured),
      intake_(
          configured,
          {.accept =
               [this](const core::PosedScan& posed) {
                 clocks_.back().scans.push_back(posed.scan);
                 clocks_.back().poses.push_back(T_earth_body_);
               },
           .reset = [this] { begin_clock(); },
           .report = [](const std::string&) {},  // The tracker's own intake says it.
           .believe = [this](const core::VehicleState& state, bool new_clock) { believe(state, new_clock); },
           .pose = [this](const core::Pose2& T_earth_body) { T_earth_body_ = T_earth_body; }}) {}

void Recorder::believe(const core::VehicleState& state, bool new_clock) {
  if (new_clock) {
    // Back on the clock of the scans, or on another still.
    const auto& states = clocks_.back().states;
    states_are_ahead_ = states.empty() || state.utime < states.back().utime ||
                        state.utime > states.back().utime + tracking::ClockGuardParams().max_step;
    next_states_.clear();
  }
  put_in_order(states_are_ahead_ ? next_states_ : clocks_.back().states, state);
}

void Recorder::add(core::GroundTruth truth) {
  auto& now = clocks_.back().truth;
  auto& list = now.empty() || truth.utime + kTruthCrosses >= now.back().utime ? now : next_truth_;
  const auto place = place_of(list, truth.utime);
  if (place != list.end() && place->utime == truth.utime)
    ++refused_truth_;
  else
    list.insert(place, std::move(truth));
}

void Recorder::begin_clock() {
  Clock next;
  next.states = std::exchange(next_states_, {});
  next.truth = std::exchange(next_truth_, {});
  states_are_ahead_ = false;
  clocks_.push_back(std::move(next));
}

void Recorder::append_to(core::Recording& recording, Clock& clock) const {
  if (!give_the_poses(clock.states, clock.scans, clock.poses, core::microseconds(configured_.max_pose_gap))) {
    // States that came after their scan would give it another pose than it had: the poses themselves are
    // kept.
    clock.states = with_poses(clock.states, clock.scans, clock.poses);
  }
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  append(recording.scans, clock.scans);
  append(recording.vehicle, clock.states);
  append(recording.truth, clock.truth);
}

core::Recording Recorder::finish() {
  intake_.finish();
  core::Recording recording;
  for (Clock& clock : clocks_) {
    if (&clock != &clocks_.front())
      recording.new_clocks.push_back(
          {recording.scans.size(), recording.vehicle.size(), recording.truth.size()});
    append_to(recording, clock);
  }
  recording.params =
      recording.scans.empty() ? configured_ : core::with_geometry_of(recording.scans.front(), configured_);
  return recording;
}

}  // namespace lookout::tools
