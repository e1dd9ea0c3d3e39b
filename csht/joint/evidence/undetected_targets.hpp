#pragma once

#include <algorithm>

#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/likelihood/scan_table.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// Mean number of targets in view that no track stands for yet: those of the prior, and those that appear or
/// enter since. They are found at the rate at which evidence comes in. It is the Poisson intensity of
/// undetected targets in a Poisson multi-Bernoulli filter ([Williams2015]), as one number.
class UndetectedTargets {
 public:
  /// @param params validated.
  UndetectedTargets(const BirthParams& params, const TargetPrior& prior)
      : params_(params), prior_(prior), mean_(prior.expected_targets()), standing_(mean_) {}

  /// Takes one scan in, `seconds` after the one before, with these figures of the sensor. @return mean().
  double update(const ScanTable& scan, const SensorFigures& figures, double seconds);
  double mean() const { return mean_; }  ///< After the newest scan, >= 0.
  /// Density of undetected targets inside the field of view over that of the prior, in [0, 1]. Those that
  /// came in over the border are not counted: they are near it still, or found already.
  double relative() const { return std::min(1.0, standing_ / prior_.expected_targets()); }

 private:
  BirthParams params_;
  TargetPrior prior_;
  double mean_;
  double standing_;           ///< Of them, those that did not come in through the border.
  double since_first_ = 0.0;  ///< [s].
};

}  // namespace lookout::csht
