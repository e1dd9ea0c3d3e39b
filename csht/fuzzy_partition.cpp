#include "csht/fuzzy_partition.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr int kBlock = WeightedPoints::kBlock;
/// Squared distance [grid steps^2] below which a point lies on a centre; keeps Eq. (22) finite there, and a
/// neighbour one step away gets a share of a millionth.
constexpr float kOnCentre = 1e-6F;

using Lanes = Eigen::Array<float, kBlock, 1>;

Eigen::Map<const Lanes> block_of(const float* values) {
  return Eigen::Map<const Lanes>(values);
}

double sum_of(const Lanes& lanes) {
  return lanes.cast<double>().sum();
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

FuzzyPartition::FuzzyPartition(double fuzzifier) : fuzzifier_(fuzzifier), squares_(fuzzifier == 2.0) {
  core::require(fuzzifier > 1.0, "fuzzifier must be > 1", fuzzifier);
}

// [Yan2018] Eq. (22) for the points of one block, mu_i = a_i / sum a with a = d^(-2/(m-1)): the affinities a
// go to the lanes, 1 / sum a to `scale_`.
void FuzzyPartition::affinities(const WeightedPoints& points, int block,
                                std::span<const FeaturePoint> centres) {
  const auto x = block_of(points.x(block)), y = block_of(points.y(block));
  scale_.setZero();
  for (std::size_t i = 0; i < centres.size(); ++i) {
    Lanes& a = affinity_[i];
    a = ((x - centres[i].x).square() + (y - centres[i].y).square() + kOnCentre).inverse();
    if (!squares_) a = a.pow(static_cast<float>(1.0 / (fuzzifier_ - 1.0)));
    scale_ += a;
  }
  scale_ = scale_.inverse();
}

/// values^m, in place.
void FuzzyPartition::raise(Lanes& values) const {
  if (squares_) {
    values = values.square();
  } else {
    values = values.pow(static_cast<float>(fuzzifier_));
  }
}

// [Yan2018] Eq. (23): Z_i = sum mu^m x / sum mu^m.
float FuzzyPartition::update(const WeightedPoints& points, std::span<FeaturePoint> centres) {
  constexpr std::size_t kSums = 3;
  affinity_.resize(centres.size());
  sums_.assign(centres.size() * kSums, Lanes::Zero());
  for (int block = 0; block < points.num_blocks(); ++block) {
    const auto x = block_of(points.x(block)), y = block_of(points.y(block));
    affinities(points, block, centres);
    raise(scale_);
    scale_ *= block_of(points.weight(block));
    for (std::size_t i = 0; i < centres.size(); ++i) {
      Lanes& share = affinity_[i];
      raise(share);
      share *= scale_;
      Lanes* const sums = sums_.data() + i * kSums;
      sums[0] += share;
      sums[1] += share * x;
      sums[2] += share * y;
    }
  }
  return move(centres);
}

/// Puts the centres at their weighted means.
float FuzzyPartition::move(std::span<FeaturePoint> centres) const {
  constexpr std::size_t kSums = 3;
  float farthest = 0.0F;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Lanes* const sums = sums_.data() + i * kSums;
    const double total = sum_of(sums[0]);
    if (!(total > 0.0)) continue;
    const FeaturePoint moved{static_cast<float>(sum_of(sums[1]) / total),
                             static_cast<float>(sum_of(sums[2]) / total)};
    farthest = std::max(farthest, std::hypot(moved.x - centres[i].x, moved.y - centres[i].y));
    centres[i] = moved;
  }
  return farthest;
}

std::span<const PatternStatistics> FuzzyPartition::statistics(const WeightedPoints& points,
                                                              std::span<const FeaturePoint> centres,
                                                              double theta) {
  constexpr std::size_t kSums = 5;
  affinity_.resize(centres.size());
  sums_.assign(centres.size() * kSums, Lanes::Zero());
  for (int block = 0; block < points.num_blocks(); ++block) {
    const auto x = block_of(points.x(block)), y = block_of(points.y(block)),
               weight = block_of(points.weight(block));
    affinities(points, block, centres);
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const Lanes mu = affinity_[i] * scale_, share = mu * weight;
      const Lanes core = (mu > static_cast<float>(theta)).cast<float>();
      Lanes* const sums = sums_.data() + i * kSums;
      sums[0] += share;
      sums[1] += core * share;
      sums[2] += core * weight;
      sums[3] += share * (x - centres[i].x).square();
      sums[4] += share * (y - centres[i].y).square();
    }
  }
  // Eq. (27) divides by N - 1, which fails for a weight of less than two points.
  const double degrees = std::max(points.total_weight() - 1.0, 1.0);
  statistics_.resize(centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Lanes* const sums = sums_.data() + i * kSums;
    statistics_[i] = {sum_of(sums[0]),
                      sum_of(sums[1]),
                      sum_of(sums[2]),
                      {std::sqrt(sum_of(sums[3]) / degrees), std::sqrt(sum_of(sums[4]) / degrees)}};
  }
  return statistics_;
}

}  // namespace lookout::csht
