#pragma once

#include <array>
#include <cmath>
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

  /// Where a return lies in the frame.
  struct Spot {
    bool counts = false;                     ///< Neither in the middle nor outside.
    bool beside = false;                     ///< On a side; else at an end.
    std::size_t second = 0;                  ///< 0: left or nearer, 1: right or farther.
    std::array<double, kWindows> windows{};  ///< Of a side: 1 for each window that holds it, else 0.
  };
  /// @param across beams to starboard of the place. @param along reaches beyond it.
  static Spot spot_of(double across, double along) {
    const double a = std::abs(across), b = std::abs(along);
    if (a > kBeams || b > kReaches) return {};
    if (a <= kMiddleBeams) return {b > kMiddleReaches, false, along < 0.0 ? 0U : 1U, {}};
    const auto holds = [](bool it_does) { return it_does ? 1.0 : 0.0; };
    return {true,
            true,
            across < 0.0 ? 0U : 1U,
            {holds(along <= 0.0), holds(b <= kMiddleReaches), holds(along >= 0.0)}};
  }

  /// Takes a return in, at a spot that counts. @param before it was heard before the scan at hand, else
  /// after.
  void take(const Spot& spot, double weight, bool before) {
    const std::size_t time = before ? 0 : 1;
    if (!spot.beside) {
      ends_[time][spot.second][0] += weight;
      return;
    }
    for (std::size_t k = 0; k < kWindows; ++k) sides_[time][spot.second][k] += weight * spot.windows[k];
  }

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
  static constexpr std::size_t kLevel = 1;  // The window that lies level with the place.
  template <std::size_t windows>
  using Pair =
      std::array<std::array<double, windows>, 2>;  // Two opposite sides: left and right, near and far.
  template <std::size_t windows>
  using Counts = std::array<Pair<windows>, 2>;  // Before and after.

  template <std::size_t windows>
  static double sum(const Counts<windows>& counts, std::size_t one, std::size_t other,
                    std::array<bool, 2> beyond);
  template <std::size_t windows>
  static double richer(const Counts<windows>& counts, std::size_t window);

  Counts<kWindows> sides_{};
  Counts<1> ends_{};
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
