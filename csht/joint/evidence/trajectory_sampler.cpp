#include "csht/joint/evidence/trajectory_sampler.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lookout::csht {
namespace {

constexpr std::size_t kPoolSize = 4096;

TrajectoryCovariance floored(const CloudMoments& moments, const TrajectoryCloudParams& params) {
  TrajectoryCovariance result = moments.covariance;
  const bool turn = moments.motion == Motion::constant_turn;
  const std::array floor{params.position_floor, params.velocity_floor,
                         turn ? params.turn_floor : params.acceleration_floor};
  for (int i = 0; i < 6; ++i) {
    const double least = floor[static_cast<std::size_t>(i / 2)];
    result(i, i) += least * least;
  }
  return result;
}

// The lower triangular root of the first d rows and columns.
TrajectoryCovariance root_of(const TrajectoryCovariance& covariance, int d) {
  TrajectoryCovariance root = TrajectoryCovariance::Zero();
  if (d == 4)
    root.topLeftCorner<4, 4>() = covariance.topLeftCorner<4, 4>().llt().matrixL();
  else if (d == 5)
    root.topLeftCorner<5, 5>() = covariance.topLeftCorner<5, 5>().llt().matrixL();
  else
    root = covariance.llt().matrixL();
  return root;
}

void copy_trajectory(const TrajectoryCloud& from, std::size_t i, TrajectoryCloud& to, std::size_t k) {
  to.north[k] = from.north[i];
  to.east[k] = from.east[i];
  to.north_velocity[k] = from.north_velocity[i];
  to.east_velocity[k] = from.east_velocity[i];
  if (from.motion == Motion::constant_turn) to.turn_rate[k] = from.turn_rate[i];
  if (from.motion != Motion::constant_acceleration) return;
  to.north_acceleration[k] = from.north_acceleration[i];
  to.east_acceleration[k] = from.east_acceleration[i];
}

// Adds ln of the anchor's density at each trajectory.
void add_anchor(const Anchor& anchor, const TrajectoryCloud& cloud, std::span<double> log_weight) {
  const Eigen::Matrix4d root = anchor.covariance.llt().matrixL();
  const double log_norm = -root.diagonal().array().log().sum() - 2.0 * std::log(2.0 * std::numbers::pi);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Eigen::Vector4d offset = state_at(cloud.motion, cloud.trajectory(i), anchor.seconds) - anchor.mean;
    root.triangularView<Eigen::Lower>().solveInPlace(offset);
    log_weight[i] += log_norm - 0.5 * offset.squaredNorm();
  }
}

// Makes the trajectories of `cloud` equally probable by systematic resampling ([Kitagawa1996]), through
// `spare`.
void resample(double uniform, TrajectoryCloud& cloud, TrajectoryCloud& spare) {
  const double size = static_cast<double>(cloud.size());
  double sum = cloud.weight[0];
  std::size_t i = 0;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    const double wanted = (static_cast<double>(k) + uniform) / size;
    while (sum < wanted && i + 1 < cloud.size()) sum += cloud.weight[++i];
    copy_trajectory(cloud, i, spare, k);
  }
  for (std::size_t k = 0; k < cloud.size(); ++k) copy_trajectory(spare, k, cloud, k);
  std::fill(cloud.weight.begin(), cloud.weight.end(), 1.0 / size);
}

}  // namespace

TrajectorySampler::TrajectorySampler(const TrajectoryCloudParams& params, const TargetPrior& prior,
                                     core::Random& random)
    : params_(params), prior_(prior), pool_(params.tail_freedom, kPoolSize, random) {
  const auto largest = static_cast<std::size_t>(params.trajectories);
  for (std::vector<double>* values : {&log_weight_, &log_ratio_}) values->reserve(largest);
  stepped_.reserve(largest);
}

double TrajectorySampler::log_prior(Motion motion, const Trajectory& trajectory, bool anchored) const {
  const double value = trajectory.segment<2>(2).norm();
  const double speed = anchored ? prior_.log_edge(value) : prior_.log_speed(value);
  if (motion == Motion::constant_velocity) return speed;
  const double spread = motion == Motion::constant_turn ? params_.turn_prior : params_.acceleration_prior;
  const int extra = dimensions(motion) - dimensions(Motion::constant_velocity);
  return speed - 0.5 * trajectory.tail<2>().squaredNorm() / (spread * spread) -
         extra * (std::log(spread) + 0.5 * std::log(2.0 * std::numbers::pi));
}

// Draws the cloud from a t distribution around `around`, and fills log_weight_ with minus the log of its
// density.
void TrajectorySampler::draw(const CloudMoments& around, std::size_t start, TrajectoryCloud& cloud) {
  const int d = dimensions(cloud.motion);
  const TrajectoryCovariance scaled =
      floored(around, params_) *
      (params_.proposal_scale * params_.proposal_scale * (params_.tail_freedom - 2.0) / params_.tail_freedom);
  const TrajectoryCovariance root = root_of(scaled, d);
  double log_determinant = 0.0;
  for (int k = 0; k < d; ++k) log_determinant += std::log(root(k, k));
  const std::array<double*, 6> component = cloud.components();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const ProposalPool::Draw& draw = pool_.at(start, i);
    for (int k = 0; k < d; ++k) {
      double value = around.mean[k];
      for (int l = 0; l <= k; ++l) value += root(k, l) * draw.z[static_cast<std::size_t>(l)];
      component[static_cast<std::size_t>(k)][i] = value;
    }
    log_weight_[i] = log_determinant - ProposalPool::log_density(draw, d);
  }
}

void TrajectorySampler::add_prior(const TrajectoryCloud& cloud, bool anchored,
                                  std::span<double> log_weight) const {
  for (std::size_t i = 0; i < cloud.size(); ++i)
    log_weight[i] += log_prior(cloud.motion, cloud.trajectory(i), anchored);
}

// The moments of the cloud, from which the next round proposes. Where few trajectories carry the weight, the
// weights are first tempered, their logarithms shrunk until enough do: a proposal that is too wide still
// converges, one that is too narrow never does. [Neal2001] Sec. 2.
CloudMoments TrajectorySampler::next_guess(TrajectoryCloud& cloud) {
  const double enough = params_.tempered_share * static_cast<double>(cloud.size());
  double exponent = 1.0;
  while (cloud.effective_size() < enough && exponent > params_.least_exponent) {
    exponent *= params_.tempering_step;
    for (double& log_weight : log_weight_) log_weight *= params_.tempering_step;
    normalise_log_weights(log_weight_, cloud.weight);
  }
  return cloud.moments();
}

SamplingResult TrajectorySampler::sample(const SamplingTask& task, ScanLikelihood& likelihood,
                                         core::Random& random, TrajectoryCloud& cloud) {
  const auto size = static_cast<std::size_t>(task.samples);
  cloud.motion = task.guess.motion;
  cloud.reserve(std::max(size, static_cast<std::size_t>(params_.trajectories)));
  cloud.resize(size);
  log_weight_.resize(size);
  log_ratio_.resize(size);
  CloudMoments around = task.guess;
  SamplingResult result;
  for (int round = 0; round < task.rounds; ++round) {
    draw(around, random(), cloud);
    score(cloud, around.mean, task, likelihood, log_ratio_);
    for (std::size_t i = 0; i < size; ++i) log_weight_[i] += log_ratio_[i];
    result.log_evidence =
        normalise_log_weights(log_weight_, cloud.weight) - std::log(static_cast<double>(size));
    result.effective_share = cloud.effective_size() / static_cast<double>(size);
    if (round + 1 == task.rounds || result.effective_share > params_.refresh_goal ||
        result.log_evidence < task.give_up_below)
      break;
    around = next_guess(cloud);
  }
  return result;
}

// ln of prior times likelihood ratio of each trajectory.
void TrajectorySampler::score(const TrajectoryCloud& cloud, const Trajectory& mean, const SamplingTask& task,
                              ScanLikelihood& likelihood, std::span<double> log_target) const {
  std::fill(log_target.begin(), log_target.end(), 0.0);
  likelihood.add(cloud, mean, task.ages, task.self, log_target);
  add_prior(cloud, task.anchor.has_value(), log_target);
  if (task.anchor) add_anchor(*task.anchor, cloud, log_target);
}

void TrajectorySampler::move(const SamplingTask& task, ScanLikelihood& likelihood, core::Random& random,
                             TrajectoryCloud& cloud) {
  const CloudMoments moments = cloud.moments();
  const TrajectoryCovariance root = root_of(
      floored(moments, params_) * (params_.move_scale * params_.move_scale), dimensions(cloud.motion));
  stepped_.motion = cloud.motion;
  stepped_.resize(cloud.size());
  log_weight_.resize(cloud.size());
  log_ratio_.resize(cloud.size());
  resample(random.uniform(0.0, 1.0), cloud, stepped_);
  score(cloud, moments.mean, task, likelihood, log_weight_);
  for (int k = 0; k < params_.moves; ++k) {
    step(root, random(), cloud);
    score(stepped_, moments.mean, task, likelihood, log_ratio_);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (std::log(random.uniform(0.0, 1.0)) >= log_ratio_[i] - log_weight_[i]) continue;
      copy_trajectory(stepped_, i, cloud, i);
      log_weight_[i] = log_ratio_[i];
    }
  }
}

// Fills `stepped_` with the trajectories of `cloud`, each moved at random.
void TrajectorySampler::step(const TrajectoryCovariance& root, std::size_t start,
                             const TrajectoryCloud& cloud) {
  const std::array<double*, 6> component = stepped_.components();
  const int d = dimensions(cloud.motion);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    copy_trajectory(cloud, i, stepped_, i);
    const ProposalPool::Draw& draw = pool_.at(start, i);
    for (int k = 0; k < d; ++k)
      for (int l = 0; l <= k; ++l)
        component[static_cast<std::size_t>(k)][i] += root(k, l) * draw.z[static_cast<std::size_t>(l)];
  }
}

}  // namespace lookout::csht
