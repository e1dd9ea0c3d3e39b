#pragma once

#include <vector>

#include "core/field_of_view.hpp"
#include "csht/candidate.hpp"
#include "csht/hough_window.hpp"

namespace lookout::csht {

/// When a candidate is a target, and what its evidence takes for granted.
struct CountDecisionParams {
  double min_evidence = 0.5;       ///< Log evidence that a new target needs.
  double offered_evidence = -3.0;  ///< The same of a candidate that a confirmed track offered.
  int min_support = 3;             ///< Scans with a detection of its own that a new target needs, > 0.
  int offered_support = 3;         ///< The same of an offered one, > 0.
  double relative_support = 0.36;  ///< Such scans as a share of the best target's, in [0, 1]; 0 where targets
                                   ///< enter and leave, for it assumes that all are there throughout.
  double clutter_regulariser = 4.0;  ///< Detections added to the clutter count, so that its rate is never 0,
                                     ///< > 0.
  double foreign_return = -3.0;      ///< Log likelihood ratio of another range in the target's beam, <= 0.
  double edge = 0.1;  ///< Nearer to its beam's edge [beams] a target may appear in the neighbour, in [0, .5].
  double targets_in_view = 2.0;  ///< Prior mean number of targets in the field of view, > 0.
  double prior_speed = 5.0;      ///< Their velocities fill a disc of this radius evenly [m/s], > 0.
  double velocity_sigma = 0.0;   ///< Above 0: velocities are normal with this deviation [m/s], as in
                                 ///< the fit; >= 0.
};

/// Probability that an accepted candidate exists: its log evidence holds the prior density already, so it is
/// the log odds of a new target. A candidate that stands only because a track offered it (`offered`) has
/// shown evidence before, which `offered_evidence` stands for.
double existence_of(const Candidate& candidate, const CountDecisionParams& params);

/// Decides which candidates are targets, after both axes: the log evidence of a target against clutter, from
/// what its beams reported and did not, without P_F, P_M or the number of targets.
class CountDecision {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit CountDecision(const CountDecisionParams& params);

  /// Notes which beam reported what; before any other call for a new window.
  void prepare(const HoughWindow& window);

  /// Log evidence of a refitted candidate: the likelihood ratio of its scans at the fit, integrated over the
  /// state (Laplace) and weighted with the prior density.
  /// @param free per detection whether no accepted target owns it; @param num_free how many are, each as much
  /// as the background makes of it.
  double log_evidence(const Candidate& candidate, const HoughWindow& window, double epoch,
                      const std::vector<char>& free, double num_free) const;

  /// Whether the evidence and the support suffice, `best_support` being that of the best target so far.
  bool accepts(const Candidate& candidate, int best_support) const;

  /// Whether they suffice for a new target, for which no track speaks.
  bool accepts_as_new(const Candidate& candidate, int best_support) const;

 private:
  /// What the window says of its own rates, given one candidate.
  struct Rates {
    double detection = 0.5;  ///< ln of P_D / (2 pi) over the clutter's density per metre and radian.
    double miss = 0.0;       ///< ln(1 - P_D).
    double silence = 0.0;    ///< ln((1 - P_D) / (1 - P_F)).
    double missed = 0.5;     ///< 1 - P_D.
  };
  struct View {
    core::SonarPoint point;
    bool visible = false;
  };
  View view(const Candidate& candidate, const HoughWindow& window, std::size_t scan, double epoch) const;
  Rates rates(const Candidate& candidate, const HoughWindow& window, int in_view, double num_free) const;
  double without_detection(const HoughWindow& window, std::size_t scan, const core::SonarPoint& point,
                           const std::vector<char>& free, const Rates& rates) const;
  double beam_term(const HoughWindow& window, std::size_t scan, int beam, double range,
                   const std::vector<char>& free, const Rates& rates) const;
  double log_prior_volume(const Candidate& candidate, const core::SonarParams& sonar) const;
  double log_velocity_density(const Eigen::Vector2d& velocity) const;
  bool enough(const Candidate& candidate, int support, double evidence, int best_support) const;

  CountDecisionParams params_;
  std::vector<int> reported_;  ///< Scans x beams: index of the beam's detection, -1 for silence.
  int num_beams_ = 0;
};

}  // namespace lookout::csht
