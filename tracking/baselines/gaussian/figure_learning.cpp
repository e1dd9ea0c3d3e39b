#include "tracking/baselines/gaussian/figure_learning.hpp"

#include <algorithm>

namespace lookout::tracking {
namespace {

// Before anything is learnt, and its weight in trials: the figures that the joint tracker begins with
// (csht::SensorFigureParams).
constexpr double kFirstMiss = 0.5;
constexpr double kFirstFalseAlarm = 0.2;
constexpr double kFirstWeight = 4.0;
constexpr double kMemoryScans = 600.0;  // Older scans count less, by e-folding; the same source.
constexpr double kLeast = 0.005;        // As csht::figures_of keeps probabilities away from 0 and 1.

}  // namespace

FigureLearning::FigureLearning(const core::SonarParams& given)
    : given_(given), figures_(csht::figures_of(given)) {
  miss_ = {kFirstMiss * kFirstWeight, kFirstWeight};
  false_alarm_ = {kFirstFalseAlarm * kFirstWeight, kFirstWeight};
  if (!given.miss_probability) figures_.miss_probability = kFirstMiss;
  if (!given.false_alarm_probability) figures_.false_alarm_probability = kFirstFalseAlarm;
}

void FigureLearning::Share::add(double hit, double trial) {
  constexpr double kKept = 1.0 - 1.0 / kMemoryScans;
  hits = kKept * hits + hit;
  trials = kKept * trials + trial;
}

void FigureLearning::learn(const ScanTally& tally) {
  miss_.add(std::max(0.0, tally.targets - tally.detected), tally.targets);
  false_alarm_.add(std::max(0.0, tally.false_returns), tally.empty_beams);
  if (!given_.miss_probability) figures_.miss_probability = std::clamp(miss_.mean(), kLeast, 1.0 - kLeast);
  if (!given_.false_alarm_probability)
    figures_.false_alarm_probability = std::clamp(false_alarm_.mean(), kLeast, 1.0 - kLeast);
}

}  // namespace lookout::tracking
