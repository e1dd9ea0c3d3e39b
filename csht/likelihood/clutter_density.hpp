#pragma once

namespace lookout::csht {

/// What is believed of a place before its returns are counted: with `share` it returns more than the
/// background does, and its rate in units of the background's is then a gamma variable of mean 1 and this
/// shape.
struct ExcessPrior {
  double share = 0.02;  ///< Probability that the place returns more, in (0, 1).
  double shape = 0.5;   ///< Of the gamma distribution, > 0.
};

/// ln of the Bayes factor of a rate that is unknown against the background's, `count` returns having come
/// where it makes `expected` (> 0): a negative binomial count against a Poisson one. [Gelman2013] Sec. 2.6.
double log_excess_factor(double count, double expected, double shape);

/// By how much a place returns more than the background [background's rate], >= 0: the posterior mean of its
/// rate, which is the background's with probability 1 - share (spike) or learnt (slab), less 1.
double excess_density(double count, double expected, const ExcessPrior& prior);

}  // namespace lookout::csht
