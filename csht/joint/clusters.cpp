#include "csht/joint/clusters.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"
#include "csht/likelihood/fast_math.hpp"

namespace lookout::csht {
namespace {

constexpr double kPairSigmas = 4.0;  // Echoes farther from the prediction do not count [sigma].
constexpr std::size_t kEchoesPerScan =
    3;                                 // Of a hypothesis at most, with beams: its own and both neighbours.
constexpr double kLeastRange = 1e-9;   // Keeps a direction regular at the sonar itself [m].
constexpr double kLeastWeight = 1e-6;  // Memberships below change nothing.
constexpr double kLeastDeterminant = 1e-300;  // Of a covariance that is singular but for rounding.
constexpr double kFarPosition = 30.0;         // Sigma that keeps the position of a cluster regular [m].

double blend(double from, double to, int round, int rounds) {
  return rounds == 1 ? to : from + (to - from) * round / (rounds - 1);
}

double unclaimed(const BeamMask* mask, std::size_t index, double range) {
  return mask == nullptr || range < mask->range[index] ? 1.0 : 1.0 - mask->share[index];
}

double negative_exp(double x) {
  return static_cast<double>(fast_exp(static_cast<float>(-x)));
}

// Probability that a target predicted `off` beams from a slot's centre lies in that slot, up to a factor.
double slot_weight(double off, double softness) {
  const double outside = std::max(0.0, std::abs(off) - 0.5) / softness;
  return negative_exp(0.5 * outside * outside);
}

}  // namespace

double laplace_log_odds(double log_ratio, const Eigen::Matrix4d& covariance, double log_density) {
  const double log_determinant = std::log(std::max(covariance.determinant(), kLeastDeterminant));
  return log_ratio + 2.0 * std::log(2.0 * std::numbers::pi) + 0.5 * log_determinant + log_density;
}

JointClusters::JointClusters(const JointClusterParams& params) : params_(params) {
  core::require(params.rounds >= 1, "rounds must be >= 1", params.rounds);
  core::require(params.min_support > 0.0, "min_support must be > 0", params.min_support);
  core::require(params.merge_distance > 0.0, "merge_distance must be > 0", params.merge_distance);
}

void JointClusters::refine(const ScanHistory& history, int window_scans, const ClaimSet& claims,
                           const TrajectoryPrior& prior, std::vector<TargetHypothesis>& hypotheses) {
  const int window = std::min(window_scans, history.size());
  before_.reserve(hypotheses.capacity());
  existence_.reserve(hypotheses.capacity());
  score(history, window, claims, prior, hypotheses);
  before_ = hypotheses;
  echoes_.reserve(kEchoesPerScan * hypotheses.capacity() * static_cast<std::size_t>(window));
  for (int round = 0; round < params_.rounds; ++round) {
    const Tolerance tolerance{
        blend(params_.first.sigma_scale, params_.last.sigma_scale, round, params_.rounds),
        blend(params_.first.edge_softness, params_.last.edge_softness, round, params_.rounds)};
    find_echoes(history, window, claims, tolerance, hypotheses);
    let_rivals_share(history, window, hypotheses);
    least_squares(history, prior.max_speed(), tolerance, hypotheses);
  }
  score(history, window, claims, prior, hypotheses);
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    if (hypotheses[k].score >= before_[k].score) continue;
    const double support = hypotheses[k].support;
    hypotheses[k] = before_[k];
    hypotheses[k].support = support;
  }
}

void JointClusters::find_echoes(const ScanHistory& history, int window, const ClaimSet& claims,
                                const Tolerance& tolerance, std::span<const TargetHypothesis> hypotheses) {
  echoes_.clear();
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    for (int age = 0; age < window; ++age) {
      const ScanTable& scan = history.at_age(age);
      Echo echo;
      echo.hypothesis = k;
      echo.age = age;
      predict(scan, hypotheses[k].mean, history.seconds_at_age(age), echo);
      if (echo.range > scan.max_range) continue;
      if (scan.clutter == ClutterModel::point)
        point_echoes(scan, claims.at_age(age), tolerance, echo);
      else
        beam_echoes(scan, claims.at_age(age), tolerance, echo);
    }
  }
}

void JointClusters::predict(const ScanTable& scan, const Eigen::Vector4d& state, double seconds, Echo& echo) {
  const Eigen::Vector2d to = state.head<2>() + seconds * state.tail<2>() -
                             Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  const double ahead = scan.cos_axis * to.x() + scan.sin_axis * to.y();
  const double abeam = scan.cos_axis * to.y() - scan.sin_axis * to.x();
  echo.range = to.norm();
  echo.bearing = static_cast<double>(fast_atan2(static_cast<float>(abeam), static_cast<float>(ahead)));
  echo.direction = to / std::max(echo.range, kLeastRange);
}

// The echoes of the predicted beam and of both neighbours, each as likely as the target is to lie there.
void JointClusters::beam_echoes(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance,
                                Echo echo) {
  const double beam =
      echo.bearing / scan.bearing_step + 0.5 * scan.num_beams + 0.5;  // Slot s is centred on s.
  const int middle = static_cast<int>(std::lround(beam));
  if (middle < 1 || middle > scan.num_beams) return;
  double total = 0.0, none = 0.0;
  const std::size_t first = echoes_.size();
  for (int s = middle - 1; s <= middle + 1; ++s) {
    const auto slot = static_cast<std::size_t>(s);
    const double weight = slot_weight(s - beam, tolerance.edge_softness);
    total += weight;
    none += weight * scan.base[slot];
    const double offset = scan.range[slot] - echo.range;
    const double sigmas = offset * scan.inverse_sigma / tolerance.sigma_scale;
    if (std::abs(sigmas) > kPairSigmas) continue;
    echo.index = slot;
    echo.weight = weight * unclaimed(mask, slot, echo.range) * scan.gain / tolerance.sigma_scale *
                  negative_exp(0.5 * sigmas * sigmas);
    echo.range_residual = offset;
    echo.bearing_residual = (s - beam) * scan.bearing_step;
    if (echo.weight > kLeastWeight) echoes_.push_back(echo);
  }
  for (std::size_t i = first; i < echoes_.size(); ++i) {
    echoes_[i].weight /= total;
    echoes_[i].none = none / total;
  }
}

void JointClusters::point_echoes(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance,
                                 Echo echo) {
  const double scale = 1.0 / tolerance.sigma_scale;
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    echo.range_residual = scan.detections[j].range - echo.range;
    echo.bearing_residual = core::wrap_to_pi(scan.bearing_from_axis[j] - echo.bearing);
    const double dr = echo.range_residual * scan.inverse_sigma * scale;
    const double db = echo.bearing_residual * scan.inverse_bearing_sigma * scale;
    const double square = dr * dr + db * db;
    if (square > kPairSigmas * kPairSigmas) continue;
    echo.index = j;
    echo.none = scan.base[1];
    echo.weight = scan.gain * scale * scale * negative_exp(0.5 * square) *
                  (mask == nullptr ? 1.0 : 1.0 - mask->share[j]);
    if (echo.weight > kLeastWeight) echoes_.push_back(echo);
  }
}

// [Yan2018] Eq. (22) with a noise class: an echo belongs to a hypothesis, to a rival as far as that is known
// to exist, or to nobody.
void JointClusters::let_rivals_share(const ScanHistory& history, int window,
                                     std::span<const TargetHypothesis> hypotheses) {
  claims_by_echo_.resize(std::max(claims_by_echo_.size(), static_cast<std::size_t>(window)));
  for (int age = 0; age < window; ++age) {
    const ScanTable& scan = history.at_age(age);
    claims_by_echo_[static_cast<std::size_t>(age)].assign(std::max(scan.range.size(), scan.detections.size()),
                                                          0.0);
  }
  existence_.resize(hypotheses.size());
  for (std::size_t k = 0; k < hypotheses.size(); ++k) existence_[k] = hypotheses[k].existence();
  const auto claim_of = [&](const Echo& echo) -> double& {
    return claims_by_echo_[static_cast<std::size_t>(echo.age)][echo.index];
  };
  for (const Echo& echo : echoes_)
    claim_of(echo) += existence_[echo.hypothesis] * echo.weight / std::max(echo.none, 0.05);
  for (Echo& echo : echoes_) {
    const double own = existence_[echo.hypothesis] * echo.weight / std::max(echo.none, 0.05);
    echo.weight /= 1.0 + std::max(0.0, claim_of(echo) - own);
  }
}

struct JointClusters::Step {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  double support = 0.0;

  void add(const Eigen::Vector4d& jacobian, double residual, double weight) {
    information.noalias() += weight * jacobian * jacobian.transpose();
    gradient.noalias() += weight * residual * jacobian;
  }
};

// Weighted least squares in range and bearing, one step of Gauss and Newton; [Yan2018] Eq. (23) for lines.
void JointClusters::least_squares(const ScanHistory& history, double max_speed, const Tolerance& tolerance,
                                  std::span<TargetHypothesis> hypotheses) {
  const double range_sigma = history.figures().range_sigma * tolerance.sigma_scale;
  const double bearing_sigma = history.figures().bearing_sigma * tolerance.sigma_scale;
  std::size_t next = 0;
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    Step step;
    while (next < echoes_.size() && echoes_[next].hypothesis == k) {
      const int age = echoes_[next].age;
      const std::size_t first = next;
      double total = echoes_[first].none;
      for (; next < echoes_.size() && echoes_[next].hypothesis == k && echoes_[next].age == age; ++next)
        total += echoes_[next].weight;
      const double seconds = history.seconds_at_age(age);
      for (std::size_t i = first; i < next; ++i) {
        const Echo& echo = echoes_[i];
        const double c = echo.direction.x(), s = echo.direction.y();
        const double membership = echo.weight / total;
        step.add({c, s, c * seconds, s * seconds}, echo.range_residual,
                 membership / (range_sigma * range_sigma));
        const double inverse = 1.0 / std::max(echo.range, 1.0);
        step.add(inverse * Eigen::Vector4d(-s, c, -s * seconds, c * seconds), echo.bearing_residual,
                 membership / (bearing_sigma * bearing_sigma));
        step.support += membership;
      }
    }
    TargetHypothesis& hypothesis = hypotheses[k];
    const Eigen::Vector4d prior(1.0 / (kFarPosition * kFarPosition), 1.0 / (kFarPosition * kFarPosition),
                                1.0 / (max_speed * max_speed), 1.0 / (max_speed * max_speed));
    step.information.diagonal() += prior;
    step.gradient.tail<2>() -= prior.tail<2>().cwiseProduct(hypothesis.mean.tail<2>());
    const Eigen::LLT<Eigen::Matrix4d> solver(step.information);
    hypothesis.mean += solver.solve(step.gradient);
    hypothesis.covariance = solver.solve(Eigen::Matrix4d::Identity());
    hypothesis.support = step.support;
  }
}

void JointClusters::score(const ScanHistory& history, int window_scans, const ClaimSet& claims,
                          const TrajectoryPrior& prior, std::span<TargetHypothesis> hypotheses) {
  const int window = std::min(window_scans, history.size());
  for (auto* values : {&north_, &east_, &north_velocity_, &east_velocity_, &sum_})
    values->resize(hypotheses.size());
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    north_[k] = hypotheses[k].mean[0];
    east_[k] = hypotheses[k].mean[1];
    north_velocity_[k] = hypotheses[k].mean[2];
    east_velocity_[k] = hypotheses[k].mean[3];
    sum_[k] = 0.0;
  }
  for (int age = window - 1; age >= 0; --age) {
    add_log_ratio(history.at_age(age), claims.at_age(age), {north_, east_, north_velocity_, east_velocity_},
                  history.seconds_at_age(age), params_.last, sum_);
    // A target may have come since: its log-likelihood ratio cannot stay below that of a birth.
    for (double& sum : sum_) sum = age == 0 ? sum : std::max(sum, prior.log_birth());
  }
  const double log_density = prior.log_density(history.newest());
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    hypotheses[k].score = sum_[k];
    hypotheses[k].log_odds = laplace_log_odds(sum_[k], hypotheses[k].covariance, log_density);
  }
}

void JointClusters::combine_and_delete(std::vector<TargetHypothesis>& hypotheses) const {
  std::sort(hypotheses.begin(), hypotheses.end(),
            [](const TargetHypothesis& a, const TargetHypothesis& b) { return a.log_odds > b.log_odds; });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    bool distinct =
        hypotheses[k].log_odds > params_.delete_below && hypotheses[k].support > params_.min_support;
    for (std::size_t j = 0; j < kept && distinct; ++j) {
      const Eigen::Vector4d d = hypotheses[k].mean - hypotheses[j].mean;
      distinct = d.dot(hypotheses[j].covariance.llt().solve(d)) > params_.merge_distance;
    }
    if (!distinct) continue;
    if (kept != k) hypotheses[kept] = hypotheses[k];
    ++kept;
  }
  hypotheses.resize(kept);
}

}  // namespace lookout::csht
