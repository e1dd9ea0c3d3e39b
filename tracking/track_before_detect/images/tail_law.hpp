#pragma once

#include <cstddef>
#include <span>

namespace lookout::tracking {

/// How probable a block's maximum is without a target: the share of this frame's blocks that reach it, and
/// beyond the best few per cent an exponential tail whose place and slope are learnt over the frames. The
/// tail of Rayleigh and of K-distributed amplitudes is at most exponential. [Jakeman1976]
class TailLaw {
 public:
  /// Takes the maxima of a frame's blocks in ascending order; they must stay valid until the next call.
  void learn(std::span<const double> ascending);
  /// Natural logarithm of the probability that a block without target reaches `value`, <= 0.
  double log_probability(double value) const;
  /// The value that a block without target reaches with `probability`, in (0, 1).
  double value_of(double probability) const;
  /// How many blocks the frame has.
  std::size_t blocks() const { return ascending_.size(); }

 private:
  double quantile(double upper_share) const;
  double log_rank(double value) const;

  std::span<const double> ascending_;
  double share_ = 1.0;  ///< Upper share at which the tail begins.
  double start_ = 0.0;  ///< The value there.
  double slope_ = 0.0;  ///< Of the tail: the value that costs a factor e.
  int frames_ = 0;
};

}  // namespace lookout::tracking
