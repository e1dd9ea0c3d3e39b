#include "tracking/detection/reference_level.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tracking/detection/summed_area.hpp"

namespace lookout::tracking {
namespace {

/// The box of so many cells about a cell.
CellBox about(int beam, int bin, const CellReach& reach) {
  return {beam - reach.beams, beam + reach.beams + 1, bin - reach.bins, bin + reach.bins + 1};
}

/// The mean of all reference cells. [Finn1968]
class CellAveraging : public ReferenceLevel {
 public:
  void prepare(const ImagePlane& plane, const DetectionWindow& window) override {
    area_.prepare(plane);
    window_ = window;
  }
  float at(int beam, int bin) const override {
    const CellSum all = area_.over(about(beam, bin, window_.reference));
    return static_cast<float>((all - area_.over(about(beam, bin, window_.guard))).mean());
  }

 private:
  SummedArea area_;
  DetectionWindow window_;
};

/// The smaller of the means of the nearer and of the farther reference cells: a strong echo or a step of the
/// level on one side leaves the other. [Trunk1978]
class SmallestOf : public ReferenceLevel {
 public:
  void prepare(const ImagePlane& plane, const DetectionWindow& window) override {
    area_.prepare(plane);
    window_ = window;
  }
  float at(int beam, int bin) const override {
    CellBox nearer = about(beam, bin, window_.reference), farther = nearer;
    nearer.last_bin = bin - window_.guard.bins;
    farther.first_bin = bin + window_.guard.bins + 1;
    const CellSum near = area_.over(nearer), far = area_.over(farther);
    if (near.cells == 0.0) return static_cast<float>(far.mean());
    if (far.cells == 0.0) return static_cast<float>(near.mean());
    return static_cast<float>(std::min(near.mean(), far.mean()));
  }

 private:
  SummedArea area_;
  DetectionWindow window_;
};

/// A quantile of the reference cells, as the mean that an exponential law of the same quantile has: a few
/// strong echoes among the cells do not move it. [Rohling1983]
class OrderedStatistic : public ReferenceLevel {
 public:
  explicit OrderedStatistic(const ReferenceParams& params)
      : samples_(params.samples),
        quantile_(params.quantile),
        to_mean_(static_cast<float>(-1.0 / std::log1p(-params.quantile))) {}

  void prepare(const ImagePlane& plane, const DetectionWindow& window) override {
    plane_ = &plane;
    if (same(window.guard, guard_) && same(window.reference, reference_)) return;
    guard_ = window.guard;
    reference_ = window.reference;
    choose_cells();
  }
  float at(int beam, int bin) const override {
    if (!gather_inside(beam, bin)) gather_at_border(beam, bin);
    if (values_.empty()) return 0.0F;
    const auto rank =
        values_.begin() + static_cast<std::ptrdiff_t>(quantile_ * static_cast<double>(values_.size() - 1));
    std::nth_element(values_.begin(), rank, values_.end());
    return to_mean_ * *rank;
  }

 private:
  static bool same(const CellReach& a, const CellReach& b) { return a.beams == b.beams && a.bins == b.bins; }

  /// All samples of a cell whose window lies in the plane; false of another.
  bool gather_inside(int beam, int bin) const {
    if (beam < reference_.beams || beam + reference_.beams >= plane_->num_beams || bin < reference_.bins ||
        bin + reference_.bins >= plane_->num_bins)
      return false;
    const float* cell = &plane_->row(beam)[static_cast<std::size_t>(bin)];
    values_.resize(offsets_.size());
    for (std::size_t i = 0; i < offsets_.size(); ++i)
      values_[i] = cell[static_cast<std::ptrdiff_t>(offsets_[i].beams) * plane_->num_bins + offsets_[i].bins];
    return true;
  }

  /// Those samples that there are.
  void gather_at_border(int beam, int bin) const {
    values_.clear();
    for (const CellReach& offset : offsets_) {
      const int at_beam = beam + offset.beams, at_bin = bin + offset.bins;
      const bool inside =
          at_beam >= 0 && at_beam < plane_->num_beams && at_bin >= 0 && at_bin < plane_->num_bins;
      if (inside) values_.push_back(plane_->at(at_beam, at_bin));
    }
  }

  /// Spreads the samples over the window in one sweep, every n-th cell of those outside the guard.
  void choose_cells() {
    offsets_.clear();
    std::vector<CellReach> all;
    for (int beam = -reference_.beams; beam <= reference_.beams; ++beam)
      for (int bin = -reference_.bins; bin <= reference_.bins; ++bin)
        if (std::abs(beam) > guard_.beams || std::abs(bin) > guard_.bins) all.push_back({beam, bin});
    const double step = std::max(1.0, static_cast<double>(all.size()) / samples_);
    for (double next = 0.5 * step; next < static_cast<double>(all.size()); next += step)
      offsets_.push_back(all[static_cast<std::size_t>(next)]);
    values_.reserve(offsets_.size());
  }

  int samples_;
  double quantile_;
  float to_mean_;
  CellReach guard_, reference_;
  std::vector<CellReach> offsets_;
  const ImagePlane* plane_ = nullptr;
  mutable std::vector<float> values_;
};

}  // namespace

std::vector<std::string> reference_level_names() {
  return {std::string(kCellAveraging), std::string(kOrderedStatistic), std::string(kSmallestOf)};
}

std::unique_ptr<ReferenceLevel> make_reference_level(const ReferenceParams& params) {
  if (params.method == kCellAveraging) return std::make_unique<CellAveraging>();
  if (params.method == kOrderedStatistic) return std::make_unique<OrderedStatistic>(params);
  if (params.method == kSmallestOf) return std::make_unique<SmallestOf>();
  std::string accepted;
  for (const auto& name : reference_level_names()) accepted.append(" ").append(name);
  throw std::invalid_argument("detection method `" + params.method +
                              "` is unknown, expected one of:" + accepted);
}

}  // namespace lookout::tracking
