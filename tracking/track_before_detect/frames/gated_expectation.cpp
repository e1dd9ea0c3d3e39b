// The E-step over the displayed cells near each target, for dark truncated cells. What is displayed outside
// all gates belongs to the background; its intensity is estimated from every n-th row of the frame.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "tracking/track_before_detect/frames/cell_expectation_forms.hpp"

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

class GatedExpectation : public CellExpectation {
 public:
  explicit GatedExpectation(const GateParams& params) : params_(params) {
    core::require(params.half_width_sigmas > 0.0, "half_width_sigmas must be > 0", params.half_width_sigmas);
    core::require(params.margin >= 0, "margin must be >= 0", params.margin);
    core::require(params.background_row_step >= 1, "background_row_step must be >= 1",
                  params.background_row_step);
  }

  void prepare(const IntensityFrame& frame, double threshold) override {
    frame_ = &frame;
    threshold_ = threshold;
    first_sample_ = std::min(params_.background_row_step / 2, frame.rows - 1);
    const CellWindow sampled{0, frame.columns, first_sample_, frame.rows};
    check_cells(frame, sampled, params_.background_row_step);
    collect_displayed(frame, threshold, sampled, params_.background_row_step, samples_);
  }

  const Expectation& evaluate(double background_weight, std::span<const CellModel> models) override {
    background_ = background_weight / static_cast<double>(frame_->values.size());
    result_.targets.assign(models.size(), {});
    result_.total_probability = background_weight;
    result_.total_intensity = 0.0;
    gates_.resize(models.size());
    axes_.resize(models.size());
    for (std::size_t k = 0; k < models.size(); ++k) open_gate(models[k], k);
    for (std::size_t k = 0; k < models.size(); ++k) add_gate(models, k);
    result_.total_intensity += intensity_outside();
    return result_;
  }

 private:
  /// The cells that a model reaches along one axis of `size` cells: first and one past the last.
  std::pair<int, int> reach(double mean, double variance, int size) const {
    const double half = params_.half_width_sigmas * std::sqrt(variance) + params_.margin;
    const double last = static_cast<double>(size);
    return {static_cast<int>(std::clamp(std::floor(mean - half), 0.0, last)),
            static_cast<int>(std::clamp(std::ceil(mean + half), 0.0, last))};
  }

  void open_gate(const CellModel& model, std::size_t k) {
    CellWindow& gate = gates_[k];
    std::tie(gate.first_column, gate.last_column) =
        reach(model.mean.x(), model.variance.x(), frame_->columns);
    std::tie(gate.first_row, gate.last_row) = reach(model.mean.y(), model.variance.y(), frame_->rows);
    check_cells(*frame_, gate, 1);
    ModelAxes& axes = axes_[k];
    axes.first_column = gate.first_column;
    axes.first_row = gate.first_row;
    axes.x.compute(model.mean.x(), model.variance.x(), gate.first_column, gate.columns(), moments_);
    axes.y.compute(model.mean.y(), model.variance.y(), gate.first_row, gate.rows(), moments_);
    num_integrals_ += expressions() * (gate.columns() + gate.rows());
    result_.targets[k].mass_inside = axes.mass();
    result_.total_probability += model.weight * axes.mass();
  }

  void add_gate(std::span<const CellModel> models, std::size_t k) {
    collect_displayed(*frame_, threshold_, gates_[k], 1, cells_);
    for (const DisplayedCell& cell : cells_) {
      double probability = background_;
      bool in_an_earlier_gate = false;
      for (std::size_t j = 0; j < models.size(); ++j) {
        if (!gates_[j].contains(cell.column, cell.row)) continue;
        probability += models[j].weight * axes_[j].probability(cell.column, cell.row);
        in_an_earlier_gate |= j < k;
      }
      axes_[k].add(cell.column, cell.row, cell.intensity / probability, result_.targets[k]);
      if (!in_an_earlier_gate) result_.total_intensity += cell.intensity;
    }
  }

  bool gated(int column, int row) const {
    return std::any_of(gates_.begin(), gates_.end(),
                       [&](const CellWindow& gate) { return gate.contains(column, row); });
  }

  /// Displayed intensity outside the gates, from the sampled rows.
  double intensity_outside() const {
    double sum = 0.0;
    for (const DisplayedCell& cell : samples_)
      if (!gated(cell.column, cell.row)) sum += cell.intensity;
    const int step = params_.background_row_step;
    const int num_sampled_rows = (frame_->rows - first_sample_ + step - 1) / step;
    return sum * frame_->rows / num_sampled_rows;
  }

  GateParams params_;
  const IntensityFrame* frame_ = nullptr;
  double threshold_ = 0.0, background_ = 0.0;
  int first_sample_ = 0;
  std::vector<DisplayedCell> samples_, cells_;
  std::vector<CellWindow> gates_;
  std::vector<ModelAxes> axes_;
  Expectation result_;
};

}  // namespace

std::unique_ptr<CellExpectation> make_gated_expectation(const GateParams& gate) {
  return std::make_unique<GatedExpectation>(gate);
}

}  // namespace lookout::tracking
