#include "csht/fuzzy_partition.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace lookout::csht {
namespace {

constexpr int kBlock = WeightedPoints::kBlock;
/// Squared distance [grid steps^2] below which a point lies on a centre; keeps Eq. (22) finite there, and a
/// neighbour one step away gets a share of a millionth.
constexpr float kOnCentre = 1e-6F;

double sum_of(const float* lanes) {
  return std::accumulate(lanes, lanes + kBlock, 0.0);
}

}  // namespace

void WeightedPoints::clear() {
  size_ = 0;
  total_weight_ = 0.0;
  x_.clear();
  y_.clear();
  weight_.clear();
}

void WeightedPoints::push_back(FeaturePoint point, float weight) {
  x_.push_back(point.x);
  y_.push_back(point.y);
  weight_.push_back(weight);
  total_weight_ += static_cast<double>(weight);
  ++size_;
}

void WeightedPoints::pad() {
  while (x_.size() % kBlock != 0) {
    x_.push_back(x_.back());
    y_.push_back(y_.back());
    weight_.push_back(0.0F);
  }
}

FeaturePoint WeightedPoints::mean() const {
  double x = 0.0, y = 0.0;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    x += static_cast<double>(weight_[k]) * static_cast<double>(x_[k]);
    y += static_cast<double>(weight_[k]) * static_cast<double>(y_[k]);
  }
  return {static_cast<float>(x / total_weight_), static_cast<float>(y / total_weight_)};
}

FuzzyPartition::FuzzyPartition(double exponent) : exponent_(exponent) {
  if (!(exponent > 1.0)) throw std::invalid_argument("exponent must be > 1, got " + std::to_string(exponent));
}

// [Yan2018] Eq. (22) for the points of one block: mu = d^(-2/(m-1)) / sum over the centres of the same.
void FuzzyPartition::memberships(const WeightedPoints& points, int block,
                                 std::span<const FeaturePoint> centres) {
  const float* const x = points.x(block);
  const float* const y = points.y(block);
  float total[kBlock] = {};
  const auto power = static_cast<float>(1.0 / (exponent_ - 1.0));
  for (std::size_t i = 0; i < centres.size(); ++i) {
    float* const mu = lane(i);
    for (int k = 0; k < kBlock; ++k) {
      const float dx = x[k] - centres[i].x, dy = y[k] - centres[i].y;
      mu[k] = 1.0F / (dx * dx + dy * dy + kOnCentre);
    }
    if (exponent_ != 2.0)
      for (int k = 0; k < kBlock; ++k) mu[k] = std::pow(mu[k], power);
    for (int k = 0; k < kBlock; ++k) total[k] += mu[k];
  }
  for (float& value : total) value = 1.0F / value;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    float* const mu = lane(i);
    for (int k = 0; k < kBlock; ++k) mu[k] *= total[k];
  }
}

// [Yan2018] Eq. (23): Z_i = sum mu^m x / sum mu^m.
float FuzzyPartition::update(const WeightedPoints& points, std::span<FeaturePoint> centres) {
  constexpr std::size_t kSums = 3;
  membership_.resize(centres.size() * kBlock);
  sums_.assign(centres.size() * kSums * kBlock, 0.0F);
  for (int block = 0; block < points.num_blocks(); ++block) {
    memberships(points, block, centres);
    const float* const weight = points.weight(block);
    for (std::size_t i = 0; i < centres.size(); ++i) {
      float* const mu = lane(i);
      if (exponent_ == 2.0) {
        for (int k = 0; k < kBlock; ++k) mu[k] *= mu[k] * weight[k];
      } else {
        for (int k = 0; k < kBlock; ++k) mu[k] = std::pow(mu[k], static_cast<float>(exponent_)) * weight[k];
      }
      float* const sums = sums_.data() + i * kSums * kBlock;
      for (int k = 0; k < kBlock; ++k) {
        sums[k] += mu[k];
        sums[kBlock + k] += mu[k] * points.x(block)[k];
        sums[2 * kBlock + k] += mu[k] * points.y(block)[k];
      }
    }
  }
  float farthest = 0.0F;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const float* const sums = sums_.data() + i * kSums * kBlock;
    const double total = sum_of(sums);
    if (!(total > 0.0)) continue;
    const FeaturePoint moved{static_cast<float>(sum_of(sums + kBlock) / total),
                             static_cast<float>(sum_of(sums + 2 * kBlock) / total)};
    farthest = std::max(farthest, std::hypot(moved.x - centres[i].x, moved.y - centres[i].y));
    centres[i] = moved;
  }
  return farthest;
}

std::span<const PatternStatistics> FuzzyPartition::statistics(const WeightedPoints& points,
                                                              std::span<const FeaturePoint> centres,
                                                              double theta) {
  constexpr std::size_t kSums = 5;
  membership_.resize(centres.size() * kBlock);
  sums_.assign(centres.size() * kSums * kBlock, 0.0F);
  const auto limit = static_cast<float>(theta);
  for (int block = 0; block < points.num_blocks(); ++block) {
    memberships(points, block, centres);
    const float* const weight = points.weight(block);
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const float* const mu = lane(i);
      float* const sums = sums_.data() + i * kSums * kBlock;
      for (int k = 0; k < kBlock; ++k) {
        const float share = mu[k] * weight[k];
        const float dx = points.x(block)[k] - centres[i].x, dy = points.y(block)[k] - centres[i].y;
        sums[k] += share;
        sums[kBlock + k] += mu[k] > limit ? share : 0.0F;
        sums[2 * kBlock + k] += mu[k] > limit ? weight[k] : 0.0F;
        sums[3 * kBlock + k] += share * dx * dx;
        sums[4 * kBlock + k] += share * dy * dy;
      }
    }
  }
  // Eq. (27) divides by N - 1; with less than two samples' weight that would blow up.
  const double degrees = std::max(points.total_weight() - 1.0, 1.0);
  statistics_.resize(centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const float* const sums = sums_.data() + i * kSums * kBlock;
    statistics_[i] = {
        sum_of(sums),
        sum_of(sums + kBlock),
        sum_of(sums + 2 * kBlock),
        {std::sqrt(sum_of(sums + 3 * kBlock) / degrees), std::sqrt(sum_of(sums + 4 * kBlock) / degrees)}};
  }
  return statistics_;
}

}  // namespace lookout::csht
