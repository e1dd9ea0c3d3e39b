#include "core/pose_history.hpp"

#include <mrpt/poses/CPose2DInterpolator.h>

#include <algorithm>
#include <chrono>

namespace lookout::core {
namespace {

// Of a slow sensor's vehicle a few states are many seconds, and its scans may wait for some of them.
constexpr std::size_t kLeastStates = 16;

mrpt::Clock::time_point mrpt_time(std::int64_t utime) {
  return mrpt::Clock::time_point(
      std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::microseconds(utime)));
}

std::int64_t utime_of(mrpt::Clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::microseconds>(time.time_since_epoch()).count();
}

Pose2 to_pose(const mrpt::math::TPose2D& pose) {
  return {pose.x, pose.y, wrap_to_pi(pose.phi)};
}

}  // namespace

struct PoseHistory::Impl {
  mrpt::poses::CPose2DInterpolator path;
  std::int64_t memory = kMemory;
};

PoseHistory::PoseHistory(std::int64_t max_bracket) : impl_(std::make_unique<Impl>()) {
  impl_->path.setInterpolationMethod(mrpt::poses::imLinear2Neig);
  impl_->path.setMaxTimeInterpolation(std::chrono::microseconds(max_bracket));
  impl_->memory = std::max(kMemory, 2 * max_bracket);
}

PoseHistory::~PoseHistory() = default;
PoseHistory::PoseHistory(PoseHistory&&) noexcept = default;
PoseHistory& PoseHistory::operator=(PoseHistory&&) noexcept = default;

void PoseHistory::add(const VehicleState& state) {
  auto& path = impl_->path;
  const Pose2& pose = state.T_earth_body;
  path.insert(mrpt_time(state.utime), mrpt::math::TPose2D(pose.north, pose.east, wrap_to_pi(pose.heading)));
  const std::int64_t oldest_kept = *newest() - impl_->memory;
  while (path.size() > kLeastStates && utime_of(path.begin()->first) < oldest_kept) path.erase(path.begin());
}

std::optional<Pose2> PoseHistory::at(std::int64_t utime) const {
  const auto exact = impl_->path.find(mrpt_time(utime));
  if (exact != impl_->path.end()) return to_pose(exact->second);
  // MRPT's interpolator extrapolates at neither end, and refuses a gap above its maximum.
  mrpt::math::TPose2D pose;
  bool valid = false;
  impl_->path.interpolate(mrpt_time(utime), pose, valid);
  if (!valid) return std::nullopt;
  return to_pose(pose);
}

bool PoseHistory::reaches(std::int64_t utime) const {
  return newest() && *newest() >= utime;
}

std::optional<std::int64_t> PoseHistory::gap_at(std::int64_t utime) const {
  const auto after = impl_->path.lower_bound(mrpt_time(utime));
  if (after == impl_->path.end() || after == impl_->path.begin()) return std::nullopt;
  return utime_of(after->first) - utime_of(std::prev(after)->first);
}

std::optional<std::int64_t> PoseHistory::newest() const {
  if (impl_->path.empty()) return std::nullopt;
  return utime_of(impl_->path.rbegin()->first);
}

std::size_t PoseHistory::size() const {
  return impl_->path.size();
}

void PoseHistory::clear() {
  impl_->path.clear();
}

}  // namespace lookout::core
