#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {

/// A trajectory that may be a target's, probable enough to sample its evidence.
struct BirthSeed {
  CloudMoments guess;     ///< At the newest scan; accelerations zero.
  int start_age = 0;      ///< Age of the oldest scan that speaks for it.
  int window = 0;         ///< Age of the oldest scan that it is weighed over, see `birth_window`.
  double log_odds = 0.0;  ///< Of existence [nats]: the evidence by Laplace's method around the guess.
};

/// Age of the oldest scan that a new target is weighed over: so many scans that they hold `enough_nats` of
/// information on a target in view, but no older than `window_s`. @param background share of the false
/// returns around it that are the uniform background's, in (0, 1]: the less, the longer.
int birth_window(const ScanHistory& scans, const BirthParams& params, double background = 1.0);

/// That share around a trajectory, [m, m/s] at the newest scan: the mean over its likely returns of the scans
/// up to age `oldest`; 1 where it has none.
double background_along(const Eigen::Vector4d& trajectory, const ScanHistory& scans, int oldest);

/// Weighted least squares for a trajectory at constant velocity: position [m] and velocity [m/s] at the
/// newest scan, north and east each. [BarShalom2001] Sec. 3.4.
struct LineFit {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();  ///< Inverse of the state's covariance.
  Eigen::Vector4d weighted = Eigen::Vector4d::Zero();     ///< Right side: information x state.

  /// Adds a detection at `position` [m, earth frame], made `seconds` from the newest scan.
  /// @param azimuth of its line of sight [rad], along which `range_variance` [m^2] counts; `cross_variance`
  /// [m^2] counts across it. @param membership weight in [0, 1].
  void add(const Eigen::Vector2d& position, double seconds, double azimuth, double range_variance,
           double cross_variance, double membership);
};

/// Finds seeds: pairs of detections that no track explains, the newest scan's with an older one's, each a
/// vote for one trajectory: a sparse Hough transform over north, east and both velocities, [Duda1972] for two
/// dimensions. Each pair is scored scan by scan into the past, under a likelihood with softened beam edges;
/// its best sum says since when it may be there. The best pairs are refined by least squares, in which each
/// detection has the probability of being the target's as its weight. docs/joint_estimator.md.
///
/// Work and memory are bounded by counts, never by a clock: of more detections or pairs than a search can
/// take every so many-th stands for all.
class PairSeeds {
 public:
  /// @param params validated.
  explicit PairSeeds(const BirthParams& params);

  /// Seeds at the newest scan, most probable first; valid until the next call.
  /// @param likelihood with the claims of all tracks. @param prior of the targets.
  /// @param stopped asked between the pieces of the work; once it is true nothing is proposed.
  std::span<const BirthSeed> propose(
      ScanLikelihood& likelihood, const TargetPrior& prior,
      const std::function<bool()>& stopped = [] { return false; });
  std::size_t num_pairs() const { return num_pairs_; }  ///< That were scored by the last call.

 private:
  struct SeedPoint {
    Eigen::Vector2d position;  ///< Of a detection [m, earth frame].
    int age = 0;               ///< Of its scan.
  };
  struct Score {
    double best = 0.0;  ///< Best log-likelihood ratio over windows.
    int oldest = 0;     ///< Age at which that window begins.
  };

  void collect_free_detections(const ScanLikelihood& likelihood);
  template <class Use>
  void for_each_pair(const Use& use) const;
  std::size_t most_pairs(int first_look) const;
  void pair_detections(int first_look);
  void add_pair(const SeedPoint& newest, const SeedPoint& older, double seconds);
  void score(ScanLikelihood& likelihood, int oldest);
  void keep_best(std::size_t count);
  void refine_and_merge(const ScanLikelihood& likelihood);
  int longest_window() const;
  void begin_lines(ScanLikelihood& likelihood, int age);
  void weigh(ScanLikelihood& likelihood);
  bool explained(const ScanLikelihood& likelihood, int age, std::size_t index) const;
  bool refine(const ScanLikelihood& likelihood, std::size_t index, BirthSeed& seed) const;
  void add_members(const ScanLikelihood& likelihood, int age, const Eigen::Vector4d& state,
                   LineFit& fit) const;
  bool merged(const BirthSeed& seed);

  BirthParams params_;
  TargetPrior prior_;
  const ScanHistory* scans_ = nullptr;              ///< Of the call to `propose` that runs.
  const std::function<bool()>* stopped_ = nullptr;  ///< Likewise.
  std::vector<SeedPoint> newest_, older_;
  TrajectoryCloud pairs_;
  std::size_t num_pairs_ = 0;
  std::vector<Score> scores_;
  std::vector<double> sum_, step_;
  int scored_to_ = -1;  ///< Age of the oldest scan in `sum_`.
  std::vector<std::size_t> order_;
  std::vector<BirthSeed> seeds_;
  TrajectoryCloud lines_;             ///< Of the seeds,
  std::vector<double> line_, begun_;  ///< their evidence, and that of those that begin at one scan [nats].
};

}  // namespace lookout::csht
