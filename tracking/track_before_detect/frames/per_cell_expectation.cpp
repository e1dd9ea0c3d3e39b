// The E-step as printed: six integrals in each cell of the frame and target.
#include "tracking/track_before_detect/frames/cell_expectation_forms.hpp"

namespace lookout::tracking {
namespace {

class PerCellExpectation : public CellExpectation {
 public:
  explicit PerCellExpectation(Truncation truncation) : truncation_(truncation) {}

  void prepare(const IntensityFrame& frame, double threshold) override {
    frame_ = &frame;
    threshold_ = threshold;
  }

  const Expectation& evaluate(double background_weight, std::span<const CellModel> models) override {
    result_ = {0.0, 0.0, std::vector<TargetSums>(models.size())};
    compute_probabilities(background_weight, models);
    const double refill = truncation_ == Truncation::impute && result_.total_probability > 0.0
                              ? result_.total_intensity / result_.total_probability
                              : 0.0;
    for (std::size_t k = 0; k < models.size(); ++k) add_moments(models[k], k, refill);
    return result_;
  }

 private:
  std::size_t num_cells() const { return frame_->values.size(); }

  /// P_kl, P_l, P_t and ||Z_t||: Eq. (6), (7), (8), (10).
  void compute_probabilities(double background_weight, std::span<const CellModel> models) {
    total_.assign(num_cells(), background_weight / static_cast<double>(num_cells()));
    probability_x_.resize(num_cells() * models.size());
    probability_y_.resize(num_cells() * models.size());
    for (std::size_t k = 0; k < models.size(); ++k) add_probabilities(models[k], k);
    for (std::size_t l = 0; l < num_cells(); ++l) {
      const bool displayed = frame_->values[l] > threshold_;
      if (displayed) result_.total_intensity += frame_->values[l];
      if (displayed || truncation_ == Truncation::zero) result_.total_probability += total_[l];
    }
  }

  void add_probabilities(const CellModel& model, std::size_t k) {
    std::size_t l = 0;
    for (int row = 0; row < frame_->rows; ++row)
      for (int column = 0; column < frame_->columns; ++column, ++l) {
        const std::size_t at = k * num_cells() + l;
        probability_x_[at] = cell_probability(model.mean.x(), model.variance.x(), column, column + 1);
        probability_y_[at] = cell_probability(model.mean.y(), model.variance.y(), row, row + 1);
        const double probability = probability_x_[at] * probability_y_[at];
        total_[l] += model.weight * probability;
        result_.targets[k].mass_inside += probability;
      }
    num_integrals_ += 2 * static_cast<std::int64_t>(num_cells());
  }

  /// The sums of Eq. (12), (15), (22) with the expected intensities of Eq. (9).
  void add_moments(const CellModel& model, std::size_t k, double refill) {
    std::size_t l = 0;
    for (int row = 0; row < frame_->rows; ++row)
      for (int column = 0; column < frame_->columns; ++column, ++l) {
        const std::size_t at = k * num_cells() + l;
        const double weight = frame_->values[l] > threshold_ ? frame_->values[l] / total_[l] : refill;
        const CellIntegrals in_x = moments(probability_x_[at], model.mean.x(), model.variance.x(), column);
        const CellIntegrals in_y = moments(probability_y_[at], model.mean.y(), model.variance.y(), row);
        ModelAxes::add(weight, in_x, in_y, result_.targets[k]);
      }
    num_integrals_ +=
        2 * static_cast<std::int64_t>(expressions() - 1) * static_cast<std::int64_t>(num_cells());
  }

  /// The integrals of one cell along one axis beside its probability.
  CellIntegrals moments(double probability, double mean, double variance, int cell) const {
    CellIntegrals integrals{probability, cell_first_moment(mean, variance, cell, cell + 1), 0.0};
    if (moments_ == CellMoments::second)
      integrals.second = cell_second_moment(mean, variance, cell, cell + 1);
    return integrals;
  }

  Truncation truncation_;
  const IntensityFrame* frame_ = nullptr;
  double threshold_ = 0.0;
  std::vector<double> total_, probability_x_, probability_y_;
  Expectation result_;
};

}  // namespace

std::unique_ptr<CellExpectation> make_per_cell_expectation(Truncation truncation) {
  return std::make_unique<PerCellExpectation>(truncation);
}

}  // namespace lookout::tracking
