#include "tracking/track_before_detect/frames/cell_expectation.hpp"

#include <stdexcept>

#include "tracking/track_before_detect/frames/cell_expectation_forms.hpp"

namespace lookout::tracking {

std::int64_t compute_axes(std::span<const CellModel> models, const FrameCells& cells,
                          std::vector<ModelAxes>& axes, Expectation& result) {
  result.targets.assign(models.size(), {});
  axes.resize(models.size());
  for (std::size_t k = 0; k < models.size(); ++k) {
    axes[k].x.compute(models[k].mean.x(), models[k].variance.x(), 0, cells.columns, cells.moments);
    axes[k].y.compute(models[k].mean.y(), models[k].variance.y(), 0, cells.rows, cells.moments);
    result.targets[k].mass_inside = axes[k].mass();
  }
  const std::int64_t expressions = cells.moments == CellMoments::second ? 3 : 2;
  return expressions * static_cast<std::int64_t>(models.size()) * (cells.columns + cells.rows);
}

std::unique_ptr<CellExpectation> make_cell_expectation(CellForm form, Truncation truncation,
                                                       const GateParams& gate) {
  switch (form) {
    case CellForm::per_cell:
      return make_per_cell_expectation(truncation);
    case CellForm::separable:
      return make_separable_expectation(truncation);
    case CellForm::sparse:
      return make_sparse_expectation(truncation);
    case CellForm::gated:
      if (truncation == Truncation::zero) return make_gated_expectation(gate);
      throw std::invalid_argument("the gated form needs truncation zero, got impute");
  }
  throw std::invalid_argument("unknown cell form");
}

}  // namespace lookout::tracking
