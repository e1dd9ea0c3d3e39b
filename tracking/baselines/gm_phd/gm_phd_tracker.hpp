#pragma once

#include <vector>

#include "tracking/baselines/gaussian/bernoulli_decisions.hpp"
#include "tracking/baselines/gaussian/bernoulli_track.hpp"
#include "tracking/baselines/gm_phd/phd_intensity.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// Parameters of GmPhdTracker. How they were chosen: docs/rivals.md.
struct GmPhdParams {
  SwitchingMotionParams motion;  ///< See there.
  /// See there. An intensity forgets at once what it believed before, so that one foreign return must not end
  /// a target: a fifth of the scans are taken for hidden.
  ScanViewParams view{.hidden = 0.2};
  PopulationParams population;  ///< See there.
  /// Of a label's expected number of targets.
  ExistenceParams existence{.confirm = 0.7};
  IntensityParams intensity;  ///< See there.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// The Gaussian mixture probability hypothesis density filter: the expected number of targets over the plane,
/// in place of tracks; identities are labels that components hand on. [Vo2006]
class GmPhdTracker : public Tracker {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  GmPhdTracker(const GmPhdParams& params, const core::SonarParams& sonar);

  /// Works on returns alone: `elements` are not used.
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override;
  bool explains() const override { return true; }
  void explain_to(const DecisionLog& log) override { decisions_.tell_to(log); }
  std::int64_t next_id() const override { return next_id_; }
  void set_next_id(std::int64_t id) override { next_id_ = id; }

 private:
  void follow_labels();
  void follow(BernoulliTrack& track, const LabelSum& label);
  void begin(BernoulliTrack& track);
  void tell_lost(const BernoulliTrack& track) const;
  void step_lives();
  std::span<const core::Track> report();

  GmPhdParams params_;
  SwitchingMotion motion_;
  RivalScene scene_;
  BernoulliDecisions decisions_;
  PhdIntensity intensity_;
  std::vector<BernoulliTrack> tracks_, before_;  ///< One a label, in their order.
  std::vector<core::Track> reported_;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
