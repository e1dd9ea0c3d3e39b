#include "tracking/baselines/gm_phd/phd_intensity.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {

void IntensityParams::validate() const {
  core::require_inner_share("least_weight", least_weight);
  core::require_not_negative("merge_distance", merge_distance);
  core::require(most >= 1, "most must be >= 1", most);
}

PhdIntensity::PhdIntensity(const IntensityParams& params) : params_(params) {
  params_.validate();
}

void PhdIntensity::predict(const SwitchingMotion& motion, RivalScene& scene) {
  for (auto& component : components_) {
    motion.predict(component.target, scene.seconds());
    component.weight *= scene.survival();
    component.detected = 0.0;
  }
  sum_up();
  for (auto& label : labels_) {
    label.spread = scene.view().spread_of(label.target);
    scene.view().claim(label.spread, {label.target, label.weight});
  }
}

void PhdIntensity::update(const RivalScene& scene, const SwitchingMotion& motion, std::int64_t& next_label) {
  grown_.clear();
  add_missed(scene);
  for (const auto& seen : scene.view().returns())
    add_detected(seen, scene, {scene.birth_ratio(seen), motion.born(seen.measurement), next_label++});
  components_.swap(grown_);
  keep_few();
  sum_up();
}

void PhdIntensity::add_missed(const RivalScene& scene) {
  for (const auto& component : components_) {
    const LabelSum& own = sum_of(component.label);
    const double ratio =
        scene.view().miss_ratio(scene.view().spread_of(component.target), {own.target, own.weight});
    grown_.push_back({ratio * component.weight, component.target, component.label});
  }
}

// [Vo2006]: the components share a return, with clutter and with what was never detected before (`born`, its
// weight over that of clutter).
void PhdIntensity::add_detected(const ViewedReturn& seen, const RivalScene& scene,
                                const WeightedTarget& born) {
  const std::size_t first = grown_.size();
  double total = 1.0 + born.weight;
  for (const auto& component : components_) {
    const double weight = component.weight * scene.view().return_ratio(component.target, seen);
    if (weight < params_.least_weight) continue;
    grown_.push_back({weight, updated(component.target, seen.measurement), component.label});
    total += weight;
  }
  grown_.push_back(born);
  for (std::size_t i = first; i < grown_.size(); ++i) {
    grown_[i].weight /= total;
    grown_[i].detected = grown_[i].weight;
  }
}

void PhdIntensity::keep_few() {
  std::erase_if(components_,
                [this](const WeightedTarget& component) { return component.weight < params_.least_weight; });
  reduce(components_, {.least_share = 0.0,
                       .merge_distance = params_.merge_distance,
                       .most = params_.most,
                       .across_labels = true});
}

void PhdIntensity::forget(std::int64_t label) {
  std::erase_if(components_, [label](const WeightedTarget& component) { return component.label == label; });
}

void PhdIntensity::sum_up() {
  grown_ = components_;
  std::stable_sort(grown_.begin(), grown_.end(),
                   [](const WeightedTarget& a, const WeightedTarget& b) { return a.label < b.label; });
  labels_.clear();
  for (std::size_t i = 0; i < grown_.size();) {
    LabelSum sum{grown_[i].label, 0.0, 0.0, grown_[i].target, {}};
    TargetMixture mixture(grown_[i].target);
    for (; i < grown_.size() && grown_[i].label == sum.label; ++i) {
      mixture.add(grown_[i].weight, grown_[i].target);
      sum.detected += grown_[i].detected;
    }
    sum.weight = mixture.weight();
    if (sum.weight > 0.0) sum.target = mixture.merged();
    labels_.push_back(sum);
  }
}

const LabelSum& PhdIntensity::sum_of(std::int64_t label) const {
  return *std::lower_bound(labels_.begin(), labels_.end(), label,
                           [](const LabelSum& sum, std::int64_t wanted) { return sum.label < wanted; });
}

}  // namespace lookout::tracking
