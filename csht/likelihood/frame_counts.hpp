#pragma once

#include <array>
#include <cstddef>

namespace lookout::csht {

/// The returns in a frame around a place of the fan, in beams and in reaches of the kernel along the line of
/// sight: on its sides (left and right, at the place's range) and at its ends (nearer and farther, in its
/// beams). Its middle is left out, where a target's own returns are.
class FrameCounts {
 public:
  static constexpr double kBeams = 6.0;          ///< Half width of the frame [beams],
  static constexpr double kReaches = 2.0;        ///< and half depth [reaches].
  static constexpr double kMiddleBeams = 2.0;    ///< Half width of its middle [beams],
  static constexpr double kMiddleReaches = 1.0;  ///< and half depth [reaches].

  /// What lies beyond the fan around the place: there one side stands for both.
  struct Border {
    bool left = false;   ///< No beams there.
    bool right = false;  ///< The same to the right.
    bool near = false;   ///< No ranges below.
    bool far = false;    ///< None above.
  };

  /// Takes a return `across` beams to starboard and `along` reaches beyond the place, that counts `weight`.
  /// @param before it was heard before the scan at hand, else after.
  void take(double across, double along, double weight, bool before);

  /// Returns that clutter alone brings to both sides, and to both ends. A moving target's trail lies on one
  /// side of the place in the scans before, and on the other in those after: where two sides differ by more
  /// than chance, twice the poorer one counts.
  double beside(const Border& border) const { return sum(0, border.left, border.right); }
  double around(const Border& border) const { return sum(2, border.near, border.far); }  ///< See `beside`.

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
  double sum(std::size_t first, bool first_is_beyond, bool second_is_beyond) const;

  std::array<std::array<double, 4>, 2> counts_{};  ///< Before and after; left, right, nearer, farther.
};

}  // namespace lookout::csht
