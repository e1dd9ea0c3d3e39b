#pragma once

namespace lookout::csht {

/// What is believed of a place before its returns are counted: with `share` it returns more than the
/// background does, and its rate in units of the background's is then a gamma variable of this mean and
/// shape.
struct ExcessPrior {
  double share = 0.02;  ///< Probability that the place returns more, in (0, 1).
  double shape = 0.5;   ///< Of the gamma distribution, > 0.
  double mean = 1.0;    ///< Of the gamma distribution, > 0.
};

/// What is believed of it afterwards.
struct Excess {
  double probability = 0.0;  ///< That the place returns more.
  double rate = 1.0;         ///< Mean of its rate if it does [background's rate].
  /// By how much it returns more than the background [background's rate], >= 0.
  double density() const { return rate > 1.0 ? probability * (rate - 1.0) : 0.0; }
};

/// The one of larger density; of equal ones the second.
inline const Excess& denser(const Excess& one, const Excess& other) {
  return one.density() > other.density() ? one : other;
}

/// ln of the Bayes factor of a gamma rate against the background's, `count` returns having come where it
/// makes `expected` (> 0): a negative binomial count against a Poisson one. [Gelman2013] Sec. 2.6.
double log_excess_factor(double count, double expected, const ExcessPrior& prior);

/// The place's posterior: its rate is the background's with probability 1 - share (spike) or learnt (slab).
Excess excess(double count, double expected, const ExcessPrior& prior);

}  // namespace lookout::csht
