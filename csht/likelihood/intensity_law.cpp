#include "csht/likelihood/intensity_law.hpp"

#include <algorithm>
#include <optional>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr double kFewest = 8.0;  // Returns of targets that a law is first learnt from,
constexpr double kMore = 0.25;   // and share by which they must grow for the next.

// The uniform background's share of the false returns at a slot, whether or not they spill.
double background_alone(const ScanTable& scan, std::size_t slot, double background) {
  return scan.clutter == ClutterModel::point
             ? background
             : std::min(1.0, background / static_cast<double>(scan.share[slot]));
}

}  // namespace

void validate(const IntensityLawParams& p) {
  core::require(p.classes >= 2 && p.classes <= 64 && p.classes % 2 == 0, "classes must be 2 to 64 and even",
                p.classes);
  core::require(p.target_returns >= p.classes, "target_returns must be >= classes", p.target_returns);
  core::require(p.false_returns >= p.classes, "false_returns must be >= classes", p.false_returns);
  core::require(p.most_of_scan >= 1, "most_of_scan must be >= 1", p.most_of_scan);
  core::require_positive("prior_returns", p.prior_returns);
}

IntensityLaw::IntensityLaw(const IntensityLawParams& params) : params_(params), needed_(kFewest) {
  const auto classes = static_cast<std::size_t>(params.classes);
  targets_.heard.reserve(static_cast<std::size_t>(params.target_returns));
  clutter_.heard.reserve(static_cast<std::size_t>(params.false_returns));
  sorted_.reserve(std::max(targets_.heard.capacity(), clutter_.heard.capacity()));
  for (std::vector<double>* by_class : {&edges_, &common_, &of_target_, &of_background_, &of_dense_})
    by_class->reserve(classes);
}

void IntensityLaw::Kept::take(const Heard& one, int most) {
  if (heard.size() < static_cast<std::size_t>(most)) {
    heard.push_back(one);
    return;
  }
  heard[next] = one;
  next = (next + 1) % heard.size();
}

void IntensityLaw::take(const ScanTable& scan, std::span<const double> own, std::span<const double> likely) {
  const std::size_t stride = scan.detections.size() / static_cast<std::size_t>(params_.most_of_scan) + 1;
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const std::optional<std::size_t> slot = slot_of(scan, j);
    if (!slot) continue;
    const double intensity = scan.detections[j].intensity;
    if (own[j] > 0.0) targets_.take({intensity, own[j]}, params_.target_returns);
    heard_ += own[j];
    const double background = static_cast<double>(scan.background[*slot]);
    if (j % stride == 0 && likely[j] < 1.0)
      clutter_.take({intensity, 1.0 - likely[j], background_alone(scan, *slot, background)},
                    params_.false_returns);
  }
  if (heard_ < needed_ || clutter_.heard.empty()) return;
  needed_ = heard_ + std::min(kMore * heard_, static_cast<double>(params_.target_returns));
  learn();
}

// Before its returns are counted, each kind is believed to be as all are.
void IntensityLaw::learn() {
  find_edges();
  const auto all = [](const Heard& one) { return one.weight; };
  const auto background = [](const Heard& one) { return one.weight * one.background; };
  const auto dense = [](const Heard& one) { return one.weight * (1.0 - one.background); };
  common_.assign(edges_.size() + 1, 0.0);
  count(targets_, {common_, 0.0}, all, of_target_);
  count(clutter_, {common_, 0.0}, all, of_background_);
  for (std::size_t k = 0; k < common_.size(); ++k) common_[k] = 0.5 * (of_target_[k] + of_background_[k]);
  count(targets_, {common_, params_.prior_returns}, all, of_target_);
  count(clutter_, {common_, params_.prior_returns}, background, of_background_);
  count(clutter_, {of_background_, params_.prior_returns}, dense, of_dense_);
}

// Quantiles of targets and of clutter, for where the one are rare the others may be many. Equal values share
// a class.
void IntensityLaw::find_edges() {
  edges_.clear();
  add_quantiles(targets_);
  add_quantiles(clutter_);
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

void IntensityLaw::add_quantiles(const Kept& kept) {
  sorted_.clear();
  for (const Heard& one : kept.heard) sorted_.push_back(one.intensity);
  std::sort(sorted_.begin(), sorted_.end());
  const auto parts = static_cast<std::size_t>(params_.classes / 2);
  for (std::size_t k = 1; k < parts; ++k) edges_.push_back(sorted_[k * sorted_.size() / parts]);
}

std::size_t IntensityLaw::class_of(double intensity) const {
  return static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), intensity) - edges_.begin());
}

// Shares of the classes among what is kept, each return by its weight, beside those believed before.
template <class Weight>
void IntensityLaw::count(const Kept& kept, const Prior& prior, const Weight& weight,
                         std::vector<double>& shares) const {
  shares.assign(prior.shares.size(), 0.0);
  double sum = prior.returns;
  for (std::size_t k = 0; k < shares.size(); ++k) shares[k] = prior.returns * prior.shares[k];
  for (const Heard& one : kept.heard) {
    const double counted = weight(one);
    shares[class_of(one.intensity)] += counted;
    sum += counted;
  }
  for (double& share : shares) share /= sum;
}

double IntensityLaw::loudness(double intensity, double background) const {
  if (!known()) return 1.0;
  const std::size_t k = class_of(intensity);
  const double falsely = background * of_background_[k] + (1.0 - background) * of_dense_[k];
  return falsely > 0.0 ? of_target_[k] / falsely : 1.0;  // Of a class that nothing was ever heard in.
}

void IntensityLaw::rate(const ScanTable& scan, std::span<const float> background,
                        std::vector<float>& loudness) const {
  loudness.assign(background.size(), 1.0F);
  if (!known()) return;
  for (std::size_t j = 0; j < scan.detections.size(); ++j)
    if (const std::optional<std::size_t> slot = slot_of(scan, j))
      loudness[*slot] = static_cast<float>(
          this->loudness(scan.detections[j].intensity,
                         background_alone(scan, *slot, static_cast<double>(background[*slot]))));
}

}  // namespace lookout::csht
