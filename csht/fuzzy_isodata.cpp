#include "csht/fuzzy_isodata.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

const FuzzyIsodataParams& validated(const FuzzyIsodataParams& p) {
  core::require_share_below_one("core_membership", p.core_membership);
  core::require_probability("aggregation", p.aggregation);
  core::require_not_negative("combination", p.combination);
  core::require_not_negative("division_spread", p.division_spread);
  core::require(p.division_step > 0.0, "division_step must be > 0", p.division_step);
  core::require_not_negative("deletion", p.deletion);
  core::require(p.rounds > 0, "rounds must be > 0", p.rounds);
  core::require(p.sweeps > 0, "sweeps must be > 0", p.sweeps);
  core::require(p.at_rest > 0.0, "at_rest must be > 0", p.at_rest);
  core::require_probability("division_rounds", p.division_rounds);
  return p;
}

double distance(const FeaturePoint& a, const FeaturePoint& b) {
  return static_cast<double>(std::hypot(a.x - b.x, a.y - b.y));
}

}  // namespace

FuzzyIsodata::FuzzyIsodata(const FuzzyIsodataParams& params)
    : params_(validated(params)), partition_(params.fuzzifier) {}

std::span<const FeaturePoint> FuzzyIsodata::cluster(const WeightedPoints& points,
                                                    std::span<const FeaturePoint> first) {
  centres_.assign(first.begin(), first.end());
  if (points.size() == 0) centres_.clear();
  bool settled = centres_.empty();
  converged_ = settled;
  for (int round = 0; round < params_.rounds && !settled; ++round) {
    const bool at_rest = update_to_rest(points);
    const bool may_divide = round < params_.division_rounds * params_.rounds;
    settled = adjust(points, may_divide) == Adjustment::none;
    converged_ = settled && at_rest && (may_divide || !widest());
  }
  if (!settled) update_to_rest(points);
  return centres_;
}

bool FuzzyIsodata::update_to_rest(const WeightedPoints& points) {
  for (int sweep = 0; sweep < params_.sweeps; ++sweep) {
    if (static_cast<double>(partition_.update(points, centres_)) < params_.at_rest) return true;
  }
  return false;
}

FuzzyIsodata::Adjustment FuzzyIsodata::adjust(const WeightedPoints& points, bool may_divide) {
  statistics_ = partition_.statistics(points, centres_, params_.core_membership);
  if (delete_one(points.total_weight()) == Adjustment::done) return Adjustment::done;
  if (combine_closest() == Adjustment::done) return Adjustment::done;
  return may_divide ? divide_one() : Adjustment::none;
}

double FuzzyIsodata::division_threshold() const {
  double sum = 0.0;
  for (const auto& pattern : statistics_) sum += pattern.deviation[0] + pattern.deviation[1];
  const auto patterns = static_cast<double>(statistics_.size());
  return sum / (2.0 * patterns) * (1.0 + std::pow(patterns, -params_.division_spread));  // Eq. (28), (29)
}

// The pattern with the smallest core among those of Eq. (36) and (37); the last pattern stays.
FuzzyIsodata::Adjustment FuzzyIsodata::delete_one(double total_weight) {
  if (centres_.size() < 2) return Adjustment::none;
  const double smallest_core = params_.deletion * total_weight / static_cast<double>(centres_.size());
  const double spread = division_threshold();
  std::size_t worst = centres_.size();
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    const auto& pattern = statistics_[i];
    const bool too_small = pattern.core_count <= smallest_core;
    const bool scattered = pattern.aggregation() <= params_.aggregation && pattern.deviation[0] <= spread &&
                           pattern.deviation[1] <= spread;
    if (!too_small && !scattered) continue;
    if (worst == centres_.size() || pattern.core_count < statistics_[worst].core_count) worst = i;
  }
  if (worst == centres_.size()) return Adjustment::none;
  centres_.erase(centres_.begin() + static_cast<std::ptrdiff_t>(worst));
  return Adjustment::done;
}

FuzzyIsodata::Adjustment FuzzyIsodata::combine_closest() {
  const std::size_t patterns = centres_.size();
  if (patterns < 2) return Adjustment::none;
  double sum = 0.0, closest = std::numeric_limits<double>::infinity();
  std::size_t first = 0, second = 0;
  for (std::size_t i = 0; i < patterns; ++i) {
    for (std::size_t j = i + 1; j < patterns; ++j) {
      const double apart = distance(centres_[i], centres_[j]);
      sum += apart;
      if (apart >= closest) continue;
      closest = apart;
      first = i;
      second = j;
    }
  }
  const auto k = static_cast<double>(patterns);
  const double mean = sum / (0.5 * k * (k - 1.0));
  if (closest >= mean * (1.0 - std::pow(k, -params_.combination))) return Adjustment::none;  // Eq. (25), (26)
  const double a = statistics_[first].membership, b = statistics_[second].membership;
  const auto share = static_cast<float>(a / (a + b));
  centres_[first] = {share * centres_[first].x + (1.0F - share) * centres_[second].x,
                     share * centres_[first].y + (1.0F - share) * centres_[second].y};  // Eq. (24)
  centres_.erase(centres_.begin() + static_cast<std::ptrdiff_t>(second));
  return Adjustment::done;
}

// The widest of the patterns with C_i <= A and S_ij > F_std.
std::optional<FuzzyIsodata::Feature> FuzzyIsodata::widest() const {
  std::optional<Feature> found;
  double widest = division_threshold();
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    if (statistics_[i].aggregation() > params_.aggregation) continue;
    for (int j = 0; j < 2; ++j) {
      if (statistics_[i].deviation[j] <= widest) continue;
      widest = statistics_[i].deviation[j];
      found = Feature{i, j, widest};
    }
  }
  return found;
}

// Eq. (34), (35).
FuzzyIsodata::Adjustment FuzzyIsodata::divide_one() {
  const auto feature = widest();
  if (!feature) return Adjustment::none;
  const auto step = static_cast<float>(params_.division_step * feature->deviation);
  FeaturePoint other = centres_[feature->pattern];
  (feature->axis == 0 ? other.x : other.y) -= step;
  (feature->axis == 0 ? centres_[feature->pattern].x : centres_[feature->pattern].y) += step;
  centres_.push_back(other);
  return Adjustment::done;
}

}  // namespace lookout::csht
