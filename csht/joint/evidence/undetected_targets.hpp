#pragma once

#include <algorithm>

#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/likelihood/scan_table.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// How many targets are in view that no track stands for, on average: those of the prior and those that come
/// into sight, found at the rate at which evidence comes in.
class UndetectedTargets {
 public:
  UndetectedTargets(const BirthParams& params, const TargetPrior& prior)
      : params_(params), prior_(prior), mean_(prior.expected_targets()), standing_(mean_) {}

  /// Takes one scan in, `seconds` after the one before. @return the mean after it.
  double update(const ScanTable& scan, const SensorFigures& figures, double seconds);
  double mean() const { return mean_; }
  /// Those that may stand anywhere in view, to those of the prior, 1 at most: however long nothing was seen,
  /// no more stand there than that. What came in through the border is left out: it is near it still, or
  /// found.
  double relative() const { return std::min(1.0, standing_ / prior_.expected_targets()); }

 private:
  BirthParams params_;
  TargetPrior prior_;
  double mean_;
  double standing_;           ///< Of them, those that did not come in through the border.
  double since_first_ = 0.0;  ///< [s].
};

}  // namespace lookout::csht
