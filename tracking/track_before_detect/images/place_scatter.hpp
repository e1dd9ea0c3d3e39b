#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace lookout::tracking {

/// By how much measured places scatter more, or less, than the noise of the cells alone says, in the cells of
/// each scale and along either axis. An echo's true signature is no scale's own, and lies between the cells
/// as it happens: what that does to a place goes with the pulse, the beam and the bins of the instrument, and
/// shows in the innovations of the targets that are tracked.
class PlaceScatter {
 public:
  /// Variance of a measured place over what is stated, columns and rows; 1 of what was not learnt.
  Eigen::Array2d factor(std::size_t scale) const;
  /// Learns from one innovation, columns and rows [cells of the scale].
  /// @param predicted variance of the error of the prediction [cells^2].
  /// @param stated variance of the measured place for the noise of the cells alone [cells^2]; where it
  /// is 0 nothing is learnt.
  void learn(std::size_t scale, const Eigen::Array2d& innovation, const Eigen::Array2d& predicted,
             const Eigen::Array2d& stated);
  void reset() { learnt_.clear(); }  ///< Forgets all: the scales or the tracks are others.

 private:
  struct Mean {
    Eigen::Array2d ratio{1.0, 1.0};
    double count = 0.0;  ///< Innovations, up to the memory.
  };
  std::vector<Mean> learnt_;  ///< By scale.
};

}  // namespace lookout::tracking
