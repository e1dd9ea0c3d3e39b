#include "tracking/baselines/paper_kalman_filter.hpp"

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
void PaperKalmanParams::validate() const {
  core::require_positive("process_sigma", process_sigma);
  core::require_positive("position_sigma", position_sigma);
  core::require_positive("initial_position", initial_position);
  core::require_positive("initial_velocity", initial_velocity);
}

/// The hooks that MRPT's filter asks for: state north, east, and their velocities; measured north, east.
class PaperKalmanFilter::Engine : public mrpt::bayes::CKalmanFilterCapable<4, 2, 0, 0> {
 public:
  explicit Engine(const PaperKalmanParams& params) : params_(params) {
    m_xkk.resize(4);
    m_pkk.setSize(4, 4);
  }

  bool iterate(core::Track& track, double seconds, const Choose& choose) {
    seconds_ = seconds;
    choose_ = &choose;
    chosen_ = false;
    m_xkk.asEigen() = track.state;
    m_pkk.asEigen() = track.covariance;
    runOneKalmanIteration();
    track.state = m_xkk.asEigen();
    // The engine multiplies (I - K H) P: rounding leaves it a little unsymmetric.
    track.covariance = 0.5 * (m_pkk.asEigen() + m_pkk.asEigen().transpose());
    return chosen_;
  }

 private:
  void OnGetAction(KFArray_ACT& /*action*/) const override {}

  void OnTransitionModel(const KFArray_ACT& /*action*/, KFArray_VEH& state, bool& /*skip*/) const override {
    state[0] += seconds_ * state[2];
    state[1] += seconds_ * state[3];
  }

  void OnTransitionJacobian(KFMatrix_VxV& transition) const override {
    transition.asEigen() = core::constant_velocity_transition(seconds_);
  }

  void OnTransitionNoise(KFMatrix_VxV& noise) const override {
    noise.asEigen() = core::stepwise_acceleration_noise(seconds_, params_.process_sigma);
  }

  void OnGetObservationNoise(KFMatrix_OxO& noise) const override {
    noise.setDiagonal(params_.position_sigma * params_.position_sigma);
  }

  void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& measured, std::vector<int>& association,
                                           const vector_KFArray_OBS& predicted, const KFMatrix& innovation,
                                           const std::vector<size_t>& /*indices*/,
                                           const KFMatrix_OxO& /*noise*/) override {
    measured.clear();
    association.clear();
    const Eigen::Matrix2d covariance = innovation.asEigen();
    const auto choice = (*choose_)({predicted[0][0], predicted[0][1]}, covariance);
    if (!choice) return;
    chosen_ = true;
    measured.emplace_back();
    measured[0][0] = choice->x();
    measured[0][1] = choice->y();
  }

  void OnObservationModel(const std::vector<size_t>& /*indices*/,
                          vector_KFArray_OBS& predicted) const override {
    predicted.resize(1);
    predicted[0][0] = m_xkk[0];
    predicted[0][1] = m_xkk[1];
  }

  void OnObservationJacobians(size_t /*index*/, KFMatrix_OxV& by_state,
                              KFMatrix_OxF& /*by_feature*/) const override {
    by_state.setZero();
    by_state(0, 0) = 1.0;
    by_state(1, 1) = 1.0;
  }

  PaperKalmanParams params_;
  double seconds_ = 0.0;
  const Choose* choose_ = nullptr;
  bool chosen_ = false;
};

PaperKalmanFilter::PaperKalmanFilter(const PaperKalmanParams& params) : params_(params) {
  params_.validate();
  engine_ = std::make_unique<Engine>(params_);
}

PaperKalmanFilter::~PaperKalmanFilter() = default;

bool PaperKalmanFilter::iterate(core::Track& track, double seconds, const Choose& choose) {
  return engine_->iterate(track, seconds, choose);
}

Eigen::Matrix4d PaperKalmanFilter::initial_covariance() const {
  const double position = params_.initial_position;
  const double velocity = params_.initial_velocity;
  return Eigen::Vector4d(position, position, velocity, velocity).asDiagonal();
}

}  // namespace lookout::tracking
