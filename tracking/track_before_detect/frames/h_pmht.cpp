#include "tracking/track_before_detect/frames/h_pmht.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/parameter_check.hpp"
#include "tracking/track_before_detect/axis_integrals.hpp"
#include "tracking/track_before_detect/frames/h_pmht_target.hpp"

namespace lookout::tracking {
namespace {

void check(const HPmhtParams& p) {
  core::require(p.batch_length >= 1, "batch_length must be >= 1", p.batch_length);
  core::require(p.iterations >= 1, "iterations must be >= 1", p.iterations);
  core::require(std::isfinite(p.dct_db), "dct_db must be finite", p.dct_db);
  core::require(p.target_area > 0.0, "target_area must be > 0", p.target_area);
  core::require(p.variance_scale > 0.0, "variance_scale must be > 0", p.variance_scale);
  core::require(p.min_variance > 0.0, "min_variance must be > 0", p.min_variance);
  core::require(p.max_variance >= p.min_variance, "max_variance must be >= min_variance", p.max_variance);
  core::require(p.max_variance_ratio.value_or(1.0) > 0.0, "max_variance_ratio must be > 0",
                p.max_variance_ratio.value_or(1.0));
  core::require(p.noise_density > 0.0, "noise_density must be > 0", p.noise_density);
  core::require(p.target_weight > 0.0 && p.target_weight < 1.0, "target_weight must be in (0, 1)",
                p.target_weight);
  core::require(p.min_weight > 0.0 && p.min_weight < 0.1, "min_weight must be in (0, 0.1)", p.min_weight);
  core::require(p.min_mass_inside >= 0.0 && p.min_mass_inside <= 1.0, "min_mass_inside must be in [0, 1]",
                p.min_mass_inside);
}

class HPmht : public FrameTracker {
 public:
  explicit HPmht(const HPmhtParams& params) : params_(params) {
    check(params);
    for (int t = 0; t < params.batch_length; ++t)
      e_steps_.push_back(make_cell_expectation(params.form, params.truncation, params.gate));
    if (!params.learn_variance)  // nothing asks for the second moments of Eq. (21), (22)
      for (auto& e_step : e_steps_) e_step->set_moments(CellMoments::first);
    background_.resize(static_cast<std::size_t>(params.batch_length) + 1);
    noise_scale_.assign(background_.size(), 1.0);
  }

  int batch_length() const override { return params_.batch_length; }

  void add(std::int64_t id, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance) override {
    const double before = static_cast<double>(targets_.size());
    const double share = params_.target_weight / (before + 1.0);
    for (HPmhtTarget& target : targets_) target.weight(0) *= before / (before + 1.0);
    targets_.emplace_back(params_, id, state, covariance, share);
    if (targets_.size() == 1) background_[0] = 1.0 - share;
  }

  void remove(std::int64_t id) override {
    std::erase_if(targets_, [id](const HPmhtTarget& target) { return target.id() == id; });
  }

  const std::vector<std::vector<FrameTrack>>& process(std::span<const IntensityFrame> frames,
                                                      std::span<const double> steps) override {
    start_batch(frames, steps);
    for (int i = 0; i < params_.iterations; ++i) {
      for (std::size_t t = 1; t <= frames.size(); ++t) expect(t);
      for (HPmhtTarget& target : targets_) target.maximise(steps);
    }
    return end_batch(frames.size());
  }

 private:
  void start_batch(std::span<const IntensityFrame> frames, std::span<const double> steps) {
    if (frames.empty() || frames.size() > e_steps_.size() || frames.size() != steps.size())
      throw std::invalid_argument("a batch must hold 1 to " + std::to_string(e_steps_.size()) +
                                  " frames, each with its step, got " + std::to_string(frames.size()));
    for (std::size_t t = 1; t <= frames.size(); ++t) {
      take_frame(frames[t - 1], t);
      background_[t] = background_[0];
    }
    for (HPmhtTarget& target : targets_) target.start_batch(steps);
  }

  void take_frame(const IntensityFrame& frame, std::size_t t) {
    // The gated form looks at few cells and checks those itself: reading them all would take longer than it.
    params_.form == CellForm::gated ? check_frame_shape(frame) : check_frame(frame);
    if (columns_ == 0) std::tie(columns_, rows_) = std::pair{frame.columns, frame.rows};
    if (frame.columns != columns_ || frame.rows != rows_)
      throw std::invalid_argument("the frames are " + std::to_string(columns_) + " x " +
                                  std::to_string(rows_) + ", got one of " + std::to_string(frame.columns) +
                                  " x " + std::to_string(frame.rows));
    e_steps_[t - 1]->prepare(frame, displayed_threshold(frame.noise_level, params_.dct_db));
  }

  /// E-step at frame t, and the mixing proportions that follow from it.
  void expect(std::size_t t) {
    models_.clear();
    for (const HPmhtTarget& target : targets_) {
      models_.push_back(target.model(t));
      if (target.lost()) models_.back().weight = 0.0;
    }
    const Expectation& expectation = e_steps_[t - 1]->evaluate(background_[t], models_);
    // An empty frame says nothing of the scale; the last one is kept.
    noise_scale_[t] = expectation.total_intensity > 0.0
                          ? expectation.total_probability / expectation.total_intensity
                          : noise_scale_[t - 1];
    for (std::size_t k = 0; k < targets_.size(); ++k)
      targets_[k].take(t, expectation, expectation.targets[k], noise_scale_[t]);
    if (expectation.total_intensity > 0.0) update_weights(t, expectation);
  }

  /// Eq. (15). The denominator, with k' as it must be, is the sum of the expected intensities.
  void update_weights(std::size_t t, const Expectation& expectation) {
    double all = background_[t];
    for (std::size_t k = 0; k < targets_.size(); ++k)
      all += models_[k].weight * expectation.targets[k].mass_inside;
    const double refilled =
        params_.truncation == Truncation::impute ? all / expectation.total_probability : 1.0;
    const double total = expectation.total_intensity * refilled;
    double rest = 1.0;
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const double share = models_[k].weight * expectation.targets[k].responsibility / total;
      targets_[k].weight(t) = std::clamp(share, params_.min_weight, 1.0 - params_.min_weight);
      if (!targets_[k].lost()) rest -= targets_[k].weight(t);
    }
    background_[t] = std::max(params_.min_weight, rest);
  }

  const std::vector<std::vector<FrameTrack>>& end_batch(std::size_t frames) {
    tracks_.resize(frames);
    for (std::size_t t = 1; t <= frames; ++t) {
      tracks_[t - 1].clear();
      for (HPmhtTarget& target : targets_) {
        lose_outside(target, t);
        tracks_[t - 1].push_back(target.track(t));
      }
    }
    for (HPmhtTarget& target : targets_) target.end_batch();
    background_[0] = background_[frames];
    noise_scale_[0] = noise_scale_[frames];
    return tracks_;
  }

  void lose_outside(HPmhtTarget& target, std::size_t t) const {
    const CellModel model = target.model(t);
    const bool inside =
        model.mean.x() >= 0.0 && model.mean.x() < columns_ && model.mean.y() >= 0.0 && model.mean.y() < rows_;
    const double mass = integrate_cell(model.mean.x(), model.variance.x(), 0, columns_).probability *
                        integrate_cell(model.mean.y(), model.variance.y(), 0, rows_).probability;
    if (!inside || mass < params_.min_mass_inside) target.lose();
  }

  HPmhtParams params_;
  int columns_ = 0, rows_ = 0;  ///< Of the first frame; 0 before it.
  std::vector<std::unique_ptr<CellExpectation>> e_steps_;
  std::vector<HPmhtTarget> targets_;
  std::vector<double> background_;   ///< pi_t0, index 0 carried over.
  std::vector<double> noise_scale_;  ///< P_t / ||Z_t||, index 0 carried over.
  std::vector<CellModel> models_;
  std::vector<std::vector<FrameTrack>> tracks_;
};

}  // namespace

double HPmhtParams::disc_variance() const {
  return target_area / (4.0 * std::numbers::pi);
}

double HPmhtParams::initial_variance() const {
  return variance_scale * disc_variance();
}

double HPmhtParams::variance_limit() const {
  if (!max_variance_ratio) return max_variance;
  return std::max(min_variance, std::min(max_variance, *max_variance_ratio * disc_variance()));
}

HPmhtParams standard_h_pmht() {
  return {};
}

HPmhtParams improved_h_pmht_4() {
  HPmhtParams params;
  params.batch_length = 1;
  return params;
}

HPmhtParams improved_h_pmht_1() {
  HPmhtParams params = improved_h_pmht_4();
  params.iterations = 1;
  params.learn_variance = false;
  return params;
}

HPmhtParams with_dark_cells(HPmhtParams params) {
  params.truncation = Truncation::zero;
  params.variance_scale = 1.5;
  params.max_variance_ratio = 2.0;
  return params;
}

std::unique_ptr<FrameTracker> make_h_pmht(const HPmhtParams& params) {
  return std::make_unique<HPmht>(params);
}

}  // namespace lookout::tracking
