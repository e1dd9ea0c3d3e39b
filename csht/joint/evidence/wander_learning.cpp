#include "csht/joint/evidence/wander_learning.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/constant_velocity.hpp"

namespace lookout::csht {
namespace {

constexpr double kChange = 0.01;      // That errors or wander are others from a return on.
constexpr double kGate = 4.0;         // Of the gating filter's standard deviations.
constexpr double kSurprise = 0.05;    // Share of returns that the widest filter alone may foretell.
constexpr double kClaimed = 0.5;      // Share of a return that others own, from which on it is not taken.
constexpr double kStaleScans = 16.0;  // Scans without a return after which a track's filters begin anew.
constexpr double kSpeedSigma = 0.5;   // Of each component of a velocity before it is known [max speed].

double density(const Eigen::Vector2d& off, const Eigen::Matrix2d& covariance) {
  return std::exp(-0.5 * off.dot(covariance.inverse() * off)) /
         (2.0 * std::numbers::pi * std::sqrt(covariance.determinant()));
}

}  // namespace

// A filter's memory: Wander::memory, of a target that is always heard.
WanderLearning::WanderLearning(const core::SonarParams& sonar) : sonar_(sonar) {
  for (std::size_t k = 0; k < kFilters; ++k) posterior_[k] = prior(k);
  if (sonar.wander && *sonar.wander > 0.0) {
    rates_.fill(*sonar.wander);
    return;
  }
  for (std::size_t k = 1; k < kRates; ++k)
    rates_[k] = 2.0 * sonar.range_sigma / (std::pow(kMemories[k - 1], 2) * std::pow(sonar.scan_period, 1.5));
}

void WanderLearning::take(const TargetTrack& track, const ScanTable& scan, const BeamMask* mask) {
  if (!sonar_.point_sensor() || track.cloud.motion != Motion::constant_velocity) return;
  Bank& bank = bank_of(track, scan.utime);
  predict(core::seconds(scan.utime - bank.utime), bank);
  bank.utime = scan.utime;
  const auto index = own_return(bank, scan, mask);
  if (!index) return;
  update(scan.detections[*index], bank);
  bank.heard_utime = scan.utime;
}

WanderLearning::Bank& WanderLearning::bank_of(const TargetTrack& track, std::int64_t utime) {
  const double longest = kStaleScans * sonar_.scan_period;
  const auto stale = [&](const Bank& bank) { return core::seconds(utime - bank.heard_utime) > longest; };
  std::erase_if(banks_, stale);
  auto bank = std::find_if(banks_.begin(), banks_.end(), [&](const Bank& b) { return b.track == track.id; });
  if (bank == banks_.end()) bank = banks_.insert(bank, Bank{});
  if (bank->track != track.id || bank->first_scan != track.first_scan) begin(track, utime, *bank);
  return *bank;
}

void WanderLearning::begin(const TargetTrack& track, std::int64_t utime, Bank& bank) const {
  bank.track = track.id;
  bank.first_scan = track.first_scan;
  bank.utime = bank.heard_utime = utime;
  const double speed = kSpeedSigma * sonar_.max_speed;
  Filter start;
  start.mean = track.moments.mean.head<4>();
  start.covariance = track.moments.covariance.topLeftCorner<4, 4>();
  start.covariance.bottomRightCorner<2, 2>() += speed * speed * Eigen::Matrix2d::Identity();
  start.covariance.topLeftCorner<2, 2>() +=
      sonar_.range_sigma * sonar_.range_sigma * Eigen::Matrix2d::Identity();
  bank.filters.fill(start);
}

void WanderLearning::predict(double seconds, Bank& bank) const {
  const Eigen::Matrix4d step = core::constant_velocity_transition(seconds);
  for (std::size_t k = 0; k < kFilters; ++k) {
    Filter& filter = bank.filters[k];
    const double rate = rates_[k % kRates];
    filter.mean = (step * filter.mean).eval();
    filter.covariance =
        (step * filter.covariance * step.transpose() + core::white_acceleration_noise(seconds, rate * rate))
            .eval();
  }
}

// The only return near the target that is no other's. Where there are several nothing is learnt.
std::optional<std::size_t> WanderLearning::own_return(const Bank& bank, const ScanTable& scan,
                                                      const BeamMask* mask) const {
  const Filter& filter = bank.filters[kGating];
  std::optional<std::size_t> own;
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const core::Detection& detection = scan.detections[j];
    const Eigen::Matrix2d spread = filter.covariance.topLeftCorner<2, 2>() + error_of(detection, 1.0);
    const Eigen::Vector2d off = detection.p_earth - filter.mean.head<2>();
    if (off.dot(spread.inverse() * off) > kGate * kGate) continue;
    if (mask != nullptr && mask->share[j] > kClaimed) continue;
    if (own) return std::nullopt;
    own = j;
  }
  return own;
}

void WanderLearning::update(const core::Detection& detection, Bank& bank) {
  std::array<double, kFilters> foretold{};
  for (std::size_t k = 0; k < kFilters; ++k) {
    Filter& filter = bank.filters[k];
    const Eigen::Matrix2d spread =
        filter.covariance.topLeftCorner<2, 2>() + error_of(detection, kFactors[k / kRates]);
    const Eigen::Vector2d off = detection.p_earth - filter.mean.head<2>();
    foretold[k] = density(off, spread);
    const Eigen::Matrix<double, 4, 2> gain = filter.covariance.leftCols<2>() * spread.inverse();
    filter.mean += gain * off;
    filter.covariance -= gain * spread * gain.transpose();
  }
  learn(foretold);
}

// Bayes' rule, then the step of a hidden Markov model whose state changes to any other.
void WanderLearning::learn(const std::array<double, kFilters>& foretold) {
  for (std::size_t k = 0; k < kFilters; ++k)
    posterior_[k] *= (1.0 - kSurprise) * foretold[k] + kSurprise * foretold.back();
  const double sum = std::max(1e-300, std::accumulate(posterior_.begin(), posterior_.end(), 0.0));
  for (std::size_t k = 0; k < kFilters; ++k)
    posterior_[k] = (1.0 - kChange) * posterior_[k] / sum + kChange * prior(k);
}

Eigen::Matrix2d WanderLearning::error_of(const core::Detection& detection, double factor) const {
  const Eigen::Vector2d along(std::cos(detection.azimuth), std::sin(detection.azimuth));
  const Eigen::Vector2d across(-along.y(), along.x());
  const double down = factor * sonar_.range_sigma;
  const double aside = factor * detection.range * sonar_.bearing_sigma_or_default();
  return down * down * along * along.transpose() + aside * aside * across * across.transpose();
}

// Every error and every rate is as probable as another, and no wander as probable as all rates together.
double WanderLearning::prior(std::size_t filter) {
  const double rate = filter % kRates == 0 ? 0.5 : 0.5 / (kRates - 1);
  return rate / static_cast<double>(kFactors.size());
}

WanderEstimate WanderLearning::estimate() const {
  WanderEstimate estimate;
  double mean = 0.0, squares = 0.0, log_factor = 0.0;
  for (std::size_t k = 0; k < kFilters; ++k) {
    log_factor += posterior_[k] * std::log(kFactors[k / kRates]);
    if (k % kRates == 0) continue;
    const double log_rate = std::log(rates_[k % kRates]);
    estimate.probability += posterior_[k];
    mean += posterior_[k] * log_rate;
    squares += posterior_[k] * log_rate * log_rate;
  }
  mean /= estimate.probability;
  squares /= estimate.probability;
  estimate.rate = std::exp(mean);
  estimate.log_sigma = std::sqrt(std::max(0.0, squares - mean * mean));
  estimate.error_factor = std::exp(log_factor);
  return estimate;
}

}  // namespace lookout::csht
