// The E-step over the displayed cells alone. Exact, refilled cells included: there the expected intensity
// over P_l is the constant c = ||Z|| / P_t, so that the sum over all cells is c times a product of axis sums
// plus the displayed cells' (z / P_l - c).
#include "tracking/track_before_detect/frames/cell_expectation_forms.hpp"

namespace lookout::tracking {
namespace {

class SparseExpectation : public CellExpectation {
 public:
  explicit SparseExpectation(Truncation truncation) : truncation_(truncation) {}

  void prepare(const IntensityFrame& frame, double threshold) override {
    columns_ = frame.columns;
    rows_ = frame.rows;
    collect_displayed(frame, threshold, {0, columns_, 0, rows_}, 1, cells_);
    total_intensity_ = 0.0;
    for (const DisplayedCell& cell : cells_) total_intensity_ += cell.intensity;
  }

  const Expectation& evaluate(double background_weight, std::span<const CellModel> models) override {
    start(models);
    compute_probabilities(background_weight, models);
    const double refill = truncation_ == Truncation::impute && result_.total_probability > 0.0
                              ? total_intensity_ / result_.total_probability
                              : 0.0;
    for (std::size_t k = 0; k < models.size(); ++k) {
      TargetSums& sums = result_.targets[k];
      axes_[k].add_all(refill, sums);
      for (std::size_t l = 0; l < cells_.size(); ++l)
        axes_[k].add(cells_[l].column, cells_[l].row, cells_[l].intensity / probability_[l] - refill, sums);
    }
    return result_;
  }

 private:
  void start(std::span<const CellModel> models) {
    result_.total_intensity = total_intensity_;
    num_integrals_ += compute_axes(models, {columns_, rows_, moments_}, axes_, result_);
  }

  /// P_l of the displayed cells and P_t.
  void compute_probabilities(double background_weight, std::span<const CellModel> models) {
    probability_.assign(cells_.size(), background_weight / (static_cast<double>(columns_) * rows_));
    for (std::size_t k = 0; k < models.size(); ++k)
      for (std::size_t l = 0; l < cells_.size(); ++l)
        probability_[l] += models[k].weight * axes_[k].probability(cells_[l].column, cells_[l].row);
    result_.total_probability = 0.0;
    if (truncation_ == Truncation::impute) {
      for (const double probability : probability_) result_.total_probability += probability;
    } else {
      result_.total_probability = background_weight;
      for (std::size_t k = 0; k < models.size(); ++k)
        result_.total_probability += models[k].weight * axes_[k].mass();
    }
  }

  Truncation truncation_;
  int columns_ = 0, rows_ = 0;
  std::vector<DisplayedCell> cells_;
  double total_intensity_ = 0.0;
  std::vector<ModelAxes> axes_;
  std::vector<double> probability_;
  Expectation result_;
};

}  // namespace

std::unique_ptr<CellExpectation> make_sparse_expectation(Truncation truncation) {
  return std::make_unique<SparseExpectation>(truncation);
}

}  // namespace lookout::tracking
