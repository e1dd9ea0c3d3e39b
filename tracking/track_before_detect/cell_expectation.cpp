#include "tracking/track_before_detect/cell_expectation.hpp"

#include <stdexcept>

#include "tracking/track_before_detect/cell_expectation_forms.hpp"

namespace lookout::tracking {

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
