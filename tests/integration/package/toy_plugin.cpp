// A plug-in: an estimator, a tracker and an initiator from outside the library, each as small as it can be.
#include "csht/estimator_registry.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/tracker_registry.hpp"

namespace {

using namespace lookout;

/// Its one target stands still at (30, 40) m, whatever the scans hold; its score counts them.
class ToyEstimator final : public csht::MotionEstimator {
 public:
  explicit ToyEstimator(int window_scans) : window_scans_(window_scans) {}
  std::span<const core::MotionElement> update(const core::PosedScan& scan) override {
    element_.initial_utime = scan.scan.utime;
    element_.initial_position = element_.position = {30.0, 40.0};
    element_.covariance = Eigen::Matrix4d::Identity();
    element_.score += 1.0;
    return {&element_, 1};
  }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::other; }
  int window_scans() const override { return window_scans_; }

 private:
  int window_scans_;
  core::MotionElement element_;
};

/// Starts a track at the first point of each scan, with the speed along x that its own key gives.
class ToyInitiator final : public tracking::Initiator {
 public:
  explicit ToyInitiator(double speed) : speed_(speed) {}
  const tracking::StartedTracks& start(const tracking::PlotWindow& window) override {
    started_ = {};
    const int newest = window.num_scans() - 1;
    if (window.size(newest) == 0) return started_;
    const tracking::Plot& plot = window.plot(window.first(newest));
    tracking::StartedTrack track;
    track.state << plot.position, speed_, 0.0;
    track.covariance.setIdentity();
    track.first_scan = track.last_scan = newest;
    track.first_time = track.last_time = plot.time;
    track.num_plots = 1;
    started_.tracks.push_back(track);
    started_.plots.push_back(window.first(newest));
    return started_;
  }
  int window_scans() const override { return 2; }
  int least_scans() const override { return 1; }  // One scan is enough for it.

 private:
  double speed_;
  tracking::StartedTracks started_;
};

/// Takes every motion element for a confirmed track.
class ToyTracker final : public tracking::Tracker {
 public:
  std::span<const core::Track> update(const core::PosedScan& /*scan*/,
                                      std::span<const core::MotionElement> elements) override {
    tracks_.clear();
    for (const auto& element : elements) {
      core::Track& track = tracks_.emplace_back();
      track.id = next_id_ + static_cast<std::int64_t>(tracks_.size()) - 1;
      track.status = core::TrackStatus::confirmed;
      track.state << element.position, element.velocity;
      track.covariance.setIdentity();
    }
    return tracks_;
  }
  std::int64_t next_id() const override { return next_id_; }
  void set_next_id(std::int64_t id) override { next_id_ = id; }

 private:
  std::int64_t next_id_ = 1;
  std::vector<core::Track> tracks_;
};

std::unique_ptr<tracking::Tracker> make_tracker(const tracking::TrackerParams& /*params*/,
                                                const core::SonarParams& /*sonar*/, std::uint64_t /*seed*/) {
  return std::make_unique<ToyTracker>();
}

std::unique_ptr<csht::MotionEstimator> make_estimator(const csht::EstimatorParams& params,
                                                      const core::SonarParams& /*sonar*/,
                                                      std::uint64_t /*seed*/) {
  return std::make_unique<ToyEstimator>(params.window_scans);
}

std::unique_ptr<tracking::Initiator> make_initiator(const tracking::InitiatorConfig& config) {
  return std::make_unique<ToyInitiator>(config.own_number("toy_speed", 1.0));
}

}  // namespace

extern "C" void lookout_register() {
  csht::register_estimator("toy", &make_estimator);
  tracking::register_tracker("toy_tracker", "toy", &make_tracker);
  tracking::register_initiator("toy", &make_initiator, {{"toy_speed", core::kNotNegative}});
}
