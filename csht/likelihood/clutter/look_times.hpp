#pragma once

#include <cstdint>
#include <vector>

#include "csht/likelihood/clutter/look_memory.hpp"

namespace lookout::csht {

/// How far in time each look of a memory is from the scan that it is to judge.
class LookTimes {
 public:
  /// How far a look is: numbers for yes (1) and no (0), to be multiplied by.
  struct LookTime {
    float other = 0.0F;      ///< It is not that scan;
    float counted = 0.0F;    ///< it judges places of the earth and corners,
    float far = 0.0F;        ///< and spots.
    std::size_t before = 0;  ///< It is earlier.
  };

  /// @param leave_out_us looks nearer in time are not counted, @param far_us nor taken for far [us], >= 0.
  LookTimes(std::int64_t leave_out_us, std::int64_t far_us) : leave_out_us_(leave_out_us), far_us_(far_us) {}
  void reserve(std::size_t looks) { times_.reserve(looks); }  ///< Marking no more allocates nothing.

  /// Notes the looks' times from the scan at `utime` [us]. What is asked below holds for the last call.
  void mark(const LookMemory& memory, std::int64_t utime);

  /// That of a look by its place in the memory, < size(), or of the look of a point.
  const LookTime& of(std::size_t index) const { return times_[index]; }
  const LookTime& of(const BinnedPoint& point) const {  ///< See above.
    return times_[static_cast<std::size_t>(point.look - first_)];
  }
  std::size_t size() const { return times_.size(); }  ///< Looks in memory.
  double counted() const { return counted_; }         ///< How many are counted,
  double far() const { return far_; }                 ///< are far,
  double others() const { return others_; }           ///< and are not the scan itself.

 private:
  std::int64_t leave_out_us_, far_us_;
  int first_ = 0;  // Number of the oldest look.
  std::vector<LookTime> times_;
  double counted_ = 0.0, far_ = 0.0, others_ = 0.0;
};

}  // namespace lookout::csht
