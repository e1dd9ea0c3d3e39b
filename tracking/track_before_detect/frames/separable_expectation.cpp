// The E-step with the integrals along the axes computed once: every sum is a product py' w px.
#include "tracking/track_before_detect/frames/cell_expectation_forms.hpp"

namespace lookout::tracking {
namespace {

Eigen::Map<const Eigen::ArrayXd> array(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

class SeparableExpectation : public CellExpectation {
 public:
  explicit SeparableExpectation(Truncation truncation) : truncation_(truncation) {}

  void prepare(const IntensityFrame& frame, double threshold) override {
    frame_ = &frame;
    const auto values = array(frame.values);
    displayed_ = (values > threshold).cast<double>();
    intensity_ = values * displayed_;
    num_displayed_ = displayed_.sum();
    total_intensity_ = intensity_.sum();
  }

  const Expectation& evaluate(double background_weight, std::span<const CellModel> models) override {
    background_ = background_weight / static_cast<double>(frame_->values.size());
    start(models);
    result_.total_probability = total_probability(background_weight, models);
    const double refill = truncation_ == Truncation::impute && result_.total_probability > 0.0
                              ? total_intensity_ / result_.total_probability
                              : 0.0;
    for (int row = 0; row < frame_->rows; ++row) add_row(row, models, refill);
    return result_;
  }

 private:
  void start(std::span<const CellModel> models) {
    result_.total_intensity = total_intensity_;
    num_integrals_ += compute_axes(models, {frame_->columns, frame_->rows, moments_}, axes_, result_);
  }

  Eigen::Map<const Eigen::ArrayXd> row_of(const Eigen::ArrayXd& image, int row) const {
    return {image.data() + static_cast<Eigen::Index>(row) * frame_->columns, frame_->columns};
  }

  /// P_t of Eq. (8): over the displayed cells, or over all of them where dark cells count.
  double total_probability(double background_weight, std::span<const CellModel> models) const {
    if (truncation_ == Truncation::zero) {
      double sum = background_weight;
      for (std::size_t k = 0; k < models.size(); ++k) sum += models[k].weight * axes_[k].mass();
      return sum;
    }
    double sum = background_ * num_displayed_;
    for (std::size_t k = 0; k < models.size(); ++k) {
      const auto in_x = array(axes_[k].x.probability());
      for (int row = 0; row < frame_->rows; ++row)
        sum += models[k].weight * axes_[k].y.probability()[static_cast<std::size_t>(row)] *
               (row_of(displayed_, row) * in_x).sum();
    }
    return sum;
  }

  void add_row(int row, std::span<const CellModel> models, double refill) {
    const auto at = static_cast<std::size_t>(row);
    weight_.setConstant(frame_->columns, background_);
    for (std::size_t k = 0; k < models.size(); ++k)
      weight_ += (models[k].weight * axes_[k].y.probability()[at]) * array(axes_[k].x.probability());
    weight_ = row_of(intensity_, row) / weight_;
    if (refill > 0.0) weight_ += refill * (1.0 - row_of(displayed_, row));
    const bool second = moments_ == CellMoments::second;
    for (std::size_t k = 0; k < models.size(); ++k) {
      const ModelAxes& axes = axes_[k];
      const CellIntegrals in_x{(weight_ * array(axes.x.probability())).sum(),
                               (weight_ * array(axes.x.first())).sum(),
                               second ? (weight_ * array(axes.x.second())).sum() : 0.0};
      ModelAxes::add(1.0, in_x, {axes.y.probability()[at], axes.y.first()[at], axes.y.second()[at]},
                     result_.targets[k]);
    }
  }

  Truncation truncation_;
  const IntensityFrame* frame_ = nullptr;
  Eigen::ArrayXd displayed_, intensity_;  ///< 1 or 0; the intensity or 0.
  double num_displayed_ = 0.0, total_intensity_ = 0.0, background_ = 0.0;
  std::vector<ModelAxes> axes_;
  Eigen::ArrayXd weight_;  ///< Expected intensity over P_l along one row.
  Expectation result_;
};

}  // namespace

std::unique_ptr<CellExpectation> make_separable_expectation(Truncation truncation) {
  return std::make_unique<SeparableExpectation>(truncation);
}

}  // namespace lookout::tracking
