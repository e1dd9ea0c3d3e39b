#include "csht/joint/sampled_evidence.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"
#include "csht/likelihood/fast_math.hpp"

namespace lookout::csht {
namespace {

constexpr std::size_t kSequence =
    4096;  // Length of the low-discrepancy sequence; stages start anywhere in it.

// Additive recurrence on the root of x^5 = x + 1, the generalised golden ratio of four dimensions
// [Roberts2018], then Box and Muller's transform pair by pair.
std::vector<Eigen::Vector4d> normal_sequence() {
  double ratio = 1.0;
  for (int i = 0; i < 60; ++i) ratio = std::pow(1.0 + ratio, 0.2);
  std::vector<Eigen::Vector4d> sequence(kSequence);
  for (std::size_t n = 0; n < kSequence; ++n) {
    Eigen::Vector4d u;
    for (int d = 0; d < 4; ++d) {
      const double value = 0.5 + static_cast<double>(n + 1) * std::pow(ratio, -(d + 1));
      u[d] = value - std::floor(value);
    }
    for (int d = 0; d < 4; d += 2) {
      const double radius = std::sqrt(-2.0 * std::log(std::max(u[d], 1e-12)));
      const double angle = 2.0 * std::numbers::pi * u[d + 1];
      sequence[n][d] = radius * std::cos(angle);
      sequence[n][d + 1] = radius * std::sin(angle);
    }
  }
  return sequence;
}

// Keeps a covariance regular that hangs on one sample: 1 cm and 1 cm/s.
const Eigen::Vector4d kLeastVariance(1e-4, 1e-4, 1e-4, 1e-4);
constexpr double kCooling = 0.7;     // Factor on the power of the weights per step of flattening.
constexpr double kLeastHeat = 0.02;  // Below it the weights are as good as flat.

constexpr int kScansPerLogarithm = 16;  // A ratio is e^-8 to e^12: to the power 16, far inside a double.

// A product of 1 that stands for `log_ratio`, and the births of a scan in its unit.
void start_product(double log_birth, std::span<const double> log_ratio, std::span<double> birth,
                   std::span<double> product) {
  for (std::size_t i = 0; i < product.size(); ++i) {
    product[i] = 1.0;
    birth[i] = std::isfinite(log_birth) ? std::exp(log_birth - log_ratio[i]) : 0.0;
  }
}

void take_logarithm(std::span<const double> product, std::span<double> log_ratio) {
  for (std::size_t i = 0; i < product.size(); ++i) log_ratio[i] += std::log(product[i]);
}

double blend(double from, double to, int stage, int stages) {
  return stages == 1 ? to : from + (to - from) * stage / (stages - 1);
}

}  // namespace

bool in_view(const ScanTable& scan, const Eigen::Vector2d& p_earth) {
  const double dn = p_earth.x() - scan.T_earth_sonar.north, de = p_earth.y() - scan.T_earth_sonar.east;
  const double square = dn * dn + de * de, ahead = scan.cos_axis * dn + scan.sin_axis * de;
  return square <= scan.max_range * scan.max_range && ahead >= scan.cos_half_sector * std::sqrt(square);
}

JointEvidence::JointEvidence(const JointEvidenceParams& params)
    : params_(params), normal_(normal_sequence()) {
  core::require(params.samples >= TargetHypothesis::kSamples, "samples must be >= 32", params.samples);
  core::require(params.screen_samples >= TargetHypothesis::kSamples, "screen_samples must be >= 32",
                params.screen_samples);
  core::require(params.stages >= 1, "stages must be >= 1", params.stages);
  core::require(params.verdict_samples >= TargetHypothesis::kSamples, "verdict_samples must be >= 32",
                params.verdict_samples);
  core::require(params.effective > 0.0 && params.effective < params.verdict_samples,
                "effective must be in (0, verdict_samples)", params.effective);
  core::require(params.attempts >= 1, "attempts must be >= 1", params.attempts);
  core::require(params.proposal_scale > 0.0, "proposal_scale must be > 0", params.proposal_scale);
  core::require(params.wide_scale > params.proposal_scale, "wide_scale must be > proposal_scale",
                params.wide_scale);
  core::require(params.wide_share > 0.0 && params.wide_share < 1.0, "wide_share must be in (0, 1)",
                params.wide_share);
  const auto size =
      static_cast<std::size_t>(std::max({params.samples, params.screen_samples, params.verdict_samples}));
  for (auto* values : {&north_, &east_, &north_velocity_, &east_velocity_, &log_proposal_, &log_ratio_,
                       &weight_, &product_, &birth_})
    values->resize(size);
}

void JointEvidence::evaluate(const ScanHistory& history, int window_scans, const ClaimSet& claims,
                             const TrajectoryPrior& prior, int stages, core::Random& random,
                             TargetHypothesis& hypothesis) {
  const int first = params_.stages - std::clamp(stages, 1, params_.stages);
  for (int stage = first; stage < params_.stages; ++stage) {
    const Tolerance tolerance{
        blend(params_.first.sigma_scale, params_.last.sigma_scale, stage, params_.stages),
        blend(params_.first.edge_softness, params_.last.edge_softness, stage, params_.stages)};
    const int samples = stage + 1 < params_.stages ? params_.screen_samples : params_.samples;
    propose(hypothesis, samples, random);
    drop_impossible(history, window_scans, prior);
    weigh(history, window_scans, claims, prior, tolerance);
    hypothesis.log_odds = log_evidence() + prior.log_density(history.newest());
    if (!(hypothesis.log_odds > params_.hopeless)) return;
    flatten(params_.adapt_share * samples);
    moments(hypothesis);
  }
  resample(random, hypothesis);
  hypothesis.sampled = true;
}

void JointEvidence::decide(const ScanHistory& history, int window_scans, const ClaimSet& claims,
                           const TrajectoryPrior& prior, core::Random& random, TargetHypothesis& hypothesis) {
  for (int attempt = 0; attempt < params_.attempts; ++attempt) {
    propose(hypothesis, params_.verdict_samples, random);
    drop_impossible(history, window_scans, prior);
    weigh(history, window_scans, claims, prior, params_.verdict);
    hypothesis.log_odds = log_evidence() + prior.log_density(history.newest());
    if (!std::isfinite(hypothesis.log_odds)) return;
    const bool enough = effective_samples_ >= params_.effective;
    flatten(params_.effective);
    moments(hypothesis);
    if (enough) break;
  }
  resample(random, hypothesis);
  hypothesis.sampled = true;
}

void JointEvidence::propose(const TargetHypothesis& hypothesis, int samples, core::Random& random) {
  count_ = static_cast<std::size_t>(samples);
  const Eigen::LLT<Eigen::Matrix4d> factor(hypothesis.covariance);
  const Eigen::Matrix4d root = factor.matrixL();
  const double log_root = std::log(root.diagonal().prod());
  const double narrow = params_.proposal_scale, wide = params_.wide_scale;
  const double log_narrow = std::log((1.0 - params_.wide_share) / std::pow(narrow, 4)) -
                            2.0 * std::log(2.0 * std::numbers::pi) - log_root;
  // Relative to the narrow part's density, so that one exponential and one logarithm do.
  const double wide_height = params_.wide_share / (1.0 - params_.wide_share) * std::pow(narrow / wide, 4);
  const double narrow_fall = 0.5 / (narrow * narrow), wide_gain = narrow_fall - 0.5 / (wide * wide);
  const auto offset = static_cast<std::size_t>(random.index(static_cast<int>(kSequence)));
  const double shift = random.uniform(0.0, 1.0);
  for (std::size_t i = 0; i < count_; ++i) {
    // Every 1 / wide_share-th sample is wide; the shift keeps the choice unbiased.
    const double turn = params_.wide_share * static_cast<double>(i) + shift;
    const bool is_wide = std::floor(turn) != std::floor(turn - params_.wide_share);
    const Eigen::Vector4d z = (is_wide ? wide : narrow) * normal_[(offset + i) % kSequence];
    const Eigen::Vector4d state = hypothesis.mean + root.triangularView<Eigen::Lower>() * z;
    const double square = z.squaredNorm();
    const double wide_part =
        wide_height * static_cast<double>(fast_exp(static_cast<float>(wide_gain * square)));
    log_proposal_[i] = log_narrow - narrow_fall * square +
                       static_cast<double>(fast_log(static_cast<float>(1.0 + wide_part)));
    north_[i] = state[0];
    east_[i] = state[1];
    north_velocity_[i] = state[2];
    east_velocity_[i] = state[3];
  }
}

// Outside the prior's support the weight is zero: too fast, or not in view when it has to be. A target that
// has left the field since the first scan stays possible, or its echoes would be made another's.
void JointEvidence::drop_impossible(const ScanHistory& history, int window_scans,
                                    const TrajectoryPrior& prior) {
  const int oldest = std::min(window_scans, history.size()) - 1;
  const double seconds = history.seconds_at_age(oldest), limit = prior.max_speed() * prior.max_speed();
  for (std::size_t i = 0; i < count_; ++i) {
    const Eigen::Vector2d position(north_[i], east_[i]), velocity(north_velocity_[i], east_velocity_[i]);
    const bool seen = in_view(history.at_age(oldest), position + seconds * velocity) ||
                      (!prior.params().in_view_from_start && in_view(history.newest(), position));
    if (!seen || velocity.squaredNorm() > limit) log_proposal_[i] = std::numeric_limits<double>::infinity();
  }
}

// From the oldest scan on, so that births within the window add as they come: the sum over all starts.
// Ratios multiply; a logarithm is taken once in several scans, before the product can leave the exponent.
void JointEvidence::weigh(const ScanHistory& history, int window_scans, const ClaimSet& claims,
                          const TrajectoryPrior& prior, const Tolerance& tolerance) {
  const auto first = [this](std::vector<double>& values) { return std::span(values.data(), count_); };
  const HypothesisSpan hypotheses{first(north_), first(east_), first(north_velocity_), first(east_velocity_)};
  const std::span<double> log_ratio = first(log_ratio_), product = first(product_), birth = first(birth_);
  const int window = std::min(window_scans, history.size());
  std::fill(log_ratio.begin(), log_ratio.end(), 0.0);
  for (int age = window - 1; age >= 0; --age) {
    if ((window - 1 - age) % kScansPerLogarithm == 0)
      start_product(prior.log_birth(), log_ratio, birth, product);
    multiply_by_ratio(history.at_age(age), claims.at_age(age), hypotheses, history.seconds_at_age(age),
                      tolerance, product);
    if (age == 0) break;
    for (std::size_t i = 0; i < count_; ++i) product[i] += birth[i];
    if ((window - age) % kScansPerLogarithm == 0) take_logarithm(product, log_ratio);
  }
  take_logarithm(product, log_ratio);
}

double JointEvidence::log_evidence() {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i) {
    log_ratio_[i] -= log_proposal_[i];
    highest = std::max(highest, log_ratio_[i]);
  }
  if (!std::isfinite(highest)) return highest;
  for (std::size_t i = 0; i < count_; ++i) log_ratio_[i] -= highest;
  return highest + std::log(temper(1.0) / static_cast<double>(count_));
}

// Weights to the power `heat`, normalised; returns their sum before.
double JointEvidence::temper(double heat) {
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    weight_[i] = static_cast<double>(fast_exp(static_cast<float>(heat * log_ratio_[i])));
    sum += weight_[i];
    squares += weight_[i] * weight_[i];
  }
  for (std::size_t i = 0; i < count_; ++i) weight_[i] /= sum;
  effective_samples_ = sum * sum / squares;
  return sum;
}

// A cloud that hangs on few samples says nothing of its width: the weights are flattened until enough count.
void JointEvidence::flatten(double wanted) {
  double heat = 1.0;
  while (effective_samples_ < wanted && heat > kLeastHeat) temper(heat *= kCooling);
}

void JointEvidence::moments(TargetHypothesis& hypothesis) const {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix4d second = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < count_; ++i) {
    const Eigen::Vector4d d =
        Eigen::Vector4d(north_[i], east_[i], north_velocity_[i], east_velocity_[i]) - hypothesis.mean;
    mean += weight_[i] * d;
    second.noalias() += weight_[i] * d * d.transpose();
  }
  hypothesis.mean += mean;
  hypothesis.covariance = second - mean * mean.transpose();
  hypothesis.covariance.diagonal() += kLeastVariance;
}

void JointEvidence::resample(core::Random& random, TargetHypothesis& hypothesis) const {
  const double step = 1.0 / TargetHypothesis::kSamples;
  double pointer = step * random.uniform(0.0, 1.0), sum = 0.0;
  std::size_t i = 0;
  for (auto& sample : hypothesis.samples) {
    while (i + 1 < count_ && sum + weight_[i] < pointer) sum += weight_[i++];
    sample = {north_[i], east_[i], north_velocity_[i], east_velocity_[i]};
    pointer += step;
  }
}

}  // namespace lookout::csht
