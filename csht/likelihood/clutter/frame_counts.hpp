#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "csht/likelihood/clutter/clutter_density.hpp"
#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// The returns in a frame around a place of the fan, in beams and in reaches of the kernel along the line of
/// sight: on its sides (left and right, in three windows over range) and at its ends (nearer and farther, in
/// its beams). Its middle is left out, where a target's own returns are.
class FrameCounts {
 public:
  static constexpr double kBeams = 6.0;          ///< Half width of the frame [beams],
  static constexpr double kReaches = 2.0;        ///< and half depth [reaches].
  static constexpr double kMiddleBeams = 2.0;    ///< Half width of its middle [beams],
  static constexpr double kMiddleReaches = 1.0;  ///< and half depth [reaches].
  static constexpr std::size_t kWindows = 3;     ///< Of a side: nearer, level with the place, farther.
  static_assert(kReaches == 2.0 * kMiddleReaches, "the windows of a side have one area");

  /// What lies beyond the fan around the place: there one side stands for both.
  struct Border {
    bool left = false;   ///< No beams there.
    bool right = false;  ///< The same to the right.
    bool near = false;   ///< No ranges below.
    bool far = false;    ///< None above.
  };
  /// What lies beyond the fan of a scan around a place. @param beam from the axis, to starboard [beams].
  /// @param reaches from the sonar, @param last_reach of the fan [reaches].
  static Border border_at(const ScanTable& scan, double beam, double reaches, double last_reach);

  /// Number of the cell that a return lies in; what is in the middle or outside has cells that nothing reads.
  /// @param across beams to starboard of the place. @param along reaches beyond it. @param before 1: it was
  /// heard before the scan at hand, 0: after.
  static std::size_t cell_of(float across, float along, std::size_t before) {
    const float column = across * (1.0F / kColumnBeams) + 0.5F * static_cast<float>(kColumns) + 1.0F,
                strip = along + 0.5F * static_cast<float>(kStrips) + 1.0F;
    const auto c = static_cast<std::size_t>(std::clamp(column, 0.0F, static_cast<float>(kColumns) + 1.5F));
    const auto s = static_cast<std::size_t>(std::clamp(strip, 0.0F, static_cast<float>(kStrips) + 1.5F));
    return index_of(before, c, s);
  }
  /// Takes a return in. @param cell see `cell_of`.
  void take(std::size_t cell, double weight) { cells_[cell] += weight; }

  /// Returns that clutter alone brings to both sides, and to both ends. A moving target's trail lies on one
  /// side of the place in the scans before, and on the other in those after: where two sides differ by more
  /// than chance, twice the poorer one counts.
  double beside(const Border& border) const;
  double around(const Border& border) const;  ///< See `beside`.
  /// As `beside`, where what is dense runs on nearer or farther than the place, as a bottom does that rises
  /// or bends: of the windows of either side, which lie a reach nearer, level with the place or a reach
  /// farther, the pair that has most.
  double slanting(const Border& border) const;

  /// Most returns for its area that a single side or end has, in units of a side's area.
  double richest() const;

  /// Area of both sides, and of both ends [beams x reaches].
  static constexpr double kBesideArea = 2.0 * (kBeams - kMiddleBeams) * 2.0 * kMiddleReaches;
  static constexpr double kAroundArea =
      2.0 * (kReaches - kMiddleReaches) * 2.0 * kMiddleBeams;  ///< See above.
  /// From the place to the middle of a side [beams] or of an end [reaches].
  static constexpr double kToSide = 0.5 * (kMiddleBeams + kBeams);
  static constexpr double kToEnd = 0.5 * (kMiddleReaches + kReaches);  ///< See above.

 private:
  // The frame has three columns over the beams and four strips over range, each a middle reach deep.
  // Around them lies one more of each, for what is outside.
  static constexpr std::size_t kLeft = 1, kMiddle = 2, kRight = 3, kColumns = 3;
  static constexpr std::size_t kNear = 1, kFar = 4, kStrips = 4;
  static constexpr std::size_t index_of(std::size_t before, std::size_t column, std::size_t strip) {
    return (before * (kColumns + 2) + column) * (kStrips + 2) + strip;
  }
  static constexpr auto kColumnBeams = static_cast<float>(2.0 * kMiddleBeams);
  static_assert(2.0 * kBeams == kColumns * 2.0 * kMiddleBeams, "the columns have one width");
  static constexpr std::size_t kLevel = 1;  // The window that lies level with the place.
  struct Pair {                             // What two opposite sides have.
    double one = 0.0, other = 0.0;
  };
  double cell(std::size_t before, std::size_t column, std::size_t strip) const {
    return cells_[index_of(before, column, strip)];
  }
  double side(std::size_t before, std::size_t column, std::size_t window) const;
  Pair sides(std::size_t before, std::size_t left, std::size_t right, const Border& border) const;
  Pair ends(std::size_t before) const;
  static double of_both(const Pair& pair);

  std::array<double, 2 * (kColumns + 2) * (kStrips + 2)> cells_{};
};

/// What a frame of counts tells of the place in its middle.
class FrameExcess {
 public:
  /// @param per_area false returns that the background brings to a unit of area of the frame, > 0.
  FrameExcess(const FrameCounts& frame, const FrameCounts::Border& border, double per_area,
              ExcessPrior prior);

  const Excess& both() const { return both_; }  ///< Of both sides, level or slanting, or of both ends.
  /// Whether the place is at a corner of what is dense, where one side or end alone has it.
  bool is_corner() const { return edge_.density() > both_.density(); }
  /// At a corner what lies at the place itself, `spot`, counts, up to what its richest side has.
  const Excess& with_corner(const Excess& spot) const;

 private:
  Excess both_, edge_;
};

}  // namespace lookout::csht
