#pragma once

#include "csht/likelihood/clutter/clutter_density.hpp"

namespace lookout::csht {

/// How a learner of places that return more than the background begins, and how long it remembers.
struct DenseReturnsParams {
  double memory_scans = 40.0;   ///< Older scans count less, by e-folding, > 1.
  double prior_returns = 20.0;  ///< Returns that what is believed before any counts for, > 0.
};

/// How many of a sensor's returns come from places that return more than the background does, and how much
/// more those return: expectation maximisation over the returns as they come ([Dempster1977], one step a
/// scan). A sea where half of all returns is of a bottom makes each new place suspect; a uniform one none.
class DenseReturns {
 public:
  /// @param params validated. @param share that is believed before any return, in (0, 1).
  DenseReturns(const DenseReturnsParams& params, double share);

  void begin_scan();  ///< What was learnt from the scans before fades.
  /// Takes a return in. @param free probability that no target made it. @param probability that its place
  /// returns more than the background. @param rate of such a place [background's rate].
  void take(double free, double probability, double rate);

  /// Share of the returns that come from such places, in (0, 1).
  double share() const { return dense_ / returns_; }
  /// Mean rate of such places [background's rate], >= 1: the place's own return tells of it, one count a
  /// return.
  double mean_rate() const;

 private:
  DenseReturnsParams params_;
  double prior_dense_;  ///< Returns from such places that are believed before any.
  double returns_, dense_, rates_ = 0.0;
};

}  // namespace lookout::csht
