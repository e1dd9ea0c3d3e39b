#include "sonar_sim/sea/fluctuation.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::sonar_sim {
namespace {

constexpr int kTableSize = 2000;
constexpr double kLeastLogSurvival = -30.0;  // rarer than one draw in 1e13
constexpr int kHalvings = 60;                // of an interval: below the resolution of a double

double from_db(double db) {
  return std::pow(10.0, 0.1 * db);
}

void check(const FluctuationPlan& plan) {
  core::require(plan.swerling >= 0 && plan.swerling <= 4, "swerling must be in 0 to 4", plan.swerling);
  core::require(plan.clutter_shape >= 0.1 && plan.clutter_shape <= 50.0, "clutter_shape must be in [0.1, 50]",
                plan.clutter_shape);
  core::require(plan.threshold >= 0.0 && plan.threshold <= 10.0, "threshold must be in [0, 10]",
                plan.threshold);
}

/// In (0, 1]: a survival probability to invert.
double draw_survival(core::Random& random) {
  return 1.0 - random.uniform(0.0, 1.0);
}

bool is_echo(const BeamReturn& heard) {
  return heard.source == Source::target || heard.source == Source::standing || heard.source == Source::spill;
}

/// How far above the threshold's power the clutter's law reaches before it is too rare to matter.
double tail_length(double shape, double least_power) {
  const double log_least = std::log(k_survival(shape, least_power));
  double length = 1.0;
  while (std::log(k_survival(shape, least_power + length)) - log_least > kLeastLogSurvival) length *= 2.0;
  return length;
}

}  // namespace

double k_survival(double shape, double power) {
  if (power <= 0.0) return 1.0;
  const double x = std::sqrt(shape * power);
  const double survival =
      2.0 * std::exp(shape * std::log(x) - std::lgamma(shape)) * std::cyl_bessel_k(shape, 2.0 * x);
  return survival <= 1.0 ? survival : 1.0;  // Near 0 the Bessel function overflows and the limit is 1.
}

double swerling_survival(int swerling, double power) {
  return swerling <= 2 ? std::exp(-power) : (1.0 + 2.0 * power) * std::exp(-2.0 * power);
}

Fluctuation::Fluctuation(const FluctuationPlan& plan) : plan_(plan) {
  check(plan);
  const double least_power = plan.threshold * plan.threshold;
  const double log_least = std::log(k_survival(plan.clutter_shape, least_power));
  const double length = tail_length(plan.clutter_shape, least_power);
  for (int i = 0; i < kTableSize; ++i) {
    // Closer together near the threshold, where most returns lie.
    const double share = static_cast<double>(i) / (kTableSize - 1);
    powers_.push_back(least_power + length * share * share * share);
    log_survivals_.push_back(std::log(k_survival(plan.clutter_shape, powers_.back())) - log_least);
  }
}

void Fluctuation::mark(std::vector<BeamReturn>& heard, core::Random& random) const {
  const bool shared = plan_.swerling % 2 == 1;
  std::map<int, double> draws;
  for (auto& one : heard) {
    double survival = draw_survival(random);
    if (is_echo(one) && shared) survival = draws.try_emplace(one.thing, survival).first->second;
    const double mean_power = from_db(one.snr_db.value_or(plan_.snr_db) - one.loss_db);
    const double power = is_echo(one) ? echo_power(mean_power, survival) : clutter_power(survival);
    one.measured.intensity = std::sqrt(power);
  }
}

double Fluctuation::clutter_power(double survival) const {
  const double wanted = std::log(survival);
  const auto below = std::lower_bound(log_survivals_.begin(), log_survivals_.end(), wanted, std::greater<>());
  if (below == log_survivals_.begin()) return powers_.front();
  if (below == log_survivals_.end()) return powers_.back();
  const auto i = static_cast<std::size_t>(below - log_survivals_.begin());
  const double share = (log_survivals_[i - 1] - wanted) / (log_survivals_[i - 1] - log_survivals_[i]);
  return powers_[i - 1] + share * (powers_[i] - powers_[i - 1]);
}

double Fluctuation::echo_power(double mean_power, double survival) const {
  const double least = plan_.threshold * plan_.threshold / mean_power;
  if (plan_.swerling == 0) return mean_power * std::max(1.0, least);
  const double exponential = least - std::log(survival);  // The exponential law forgets where it began.
  if (plan_.swerling <= 2) return mean_power * exponential;
  // The law of four degrees of freedom falls at least as fast as exp(-x) and is inverted by bisection.
  const double log_wanted = std::log(survival) + std::log1p(2.0 * least) - 2.0 * least;
  double low = least, high = least + 2.0 * (1.0 - std::log(survival));
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (std::log1p(2.0 * middle) - 2.0 * middle > log_wanted ? low : high) = middle;
  }
  return mean_power * low;
}

}  // namespace lookout::sonar_sim
