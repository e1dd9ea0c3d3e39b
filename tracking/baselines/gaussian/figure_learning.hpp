#pragma once

#include "core/sonar_params.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::tracking {

/// What a scan says of the sensor's figures.
struct ScanTally {
  double false_returns = 0.0;  ///< Expected number of returns of no target.
  double empty_beams = 0.0;    ///< Expected number of beams without a target, > 0.
  double targets = 0.0;        ///< Expected number of sure targets in view.
  double detected = 0.0;       ///< Expected number of those that were detected.
};

/// The sensor's figures: as given, and where P_F or P_M are not given, learnt
/// as running shares from the tracker's own associations.
class FigureLearning {
 public:
  explicit FigureLearning(const core::SonarParams& given);  ///< What is given is never learnt.

  const csht::SensorFigures& figures() const { return figures_; }  ///< To be used for the next scan.
  void learn(const ScanTally& tally);                              ///< Call once a scan.

 private:
  struct Share {
    double hits = 0.0, trials = 0.0;
    void add(double hit, double trial);
    double mean() const { return hits / trials; }
  };

  core::SonarParams given_;
  csht::SensorFigures figures_;
  Share miss_, false_alarm_;
};

}  // namespace lookout::tracking
