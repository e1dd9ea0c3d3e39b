#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {

/// A trajectory that may be a target's, worth the computing of its evidence.
struct BirthSeed {
  CloudMoments guess;     ///< At the newest scan; accelerations zero.
  int start_age = 0;      ///< Age of the scan since which it is thought to be there.
  double log_odds = 0.0;  ///< Of existence, by Laplace's method around the guess.
};

/// Age of the oldest scan that a new target is weighed over: as many scans as hold `enough_nats` of
/// information on a target in view, `window_s` at most.
int birth_window(const ScanHistory& scans, const BirthParams& params);

/// Weighted least squares for a straight line: state (position, velocity) at the newest scan.
struct LineFit {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d weighted = Eigen::Vector4d::Zero();

  /// An echo at `position` seen `seconds` from the newest scan, its line of sight at `azimuth`.
  void add(const Eigen::Vector2d& position, double seconds, double azimuth, double range_variance,
           double cross_variance, double membership);
};

/// Finds seeds: pairs of echoes that no track explains, the newest scan's with an older one's, each an exact
/// vote for one trajectory (a sparse Hough vote over north, east and both velocities). Scored backwards under
/// the softened likelihood; the best stretch is its window; refined by least squares over memberships.
/// docs/joint_estimator.md.
class PairSeeds {
 public:
  explicit PairSeeds(const BirthParams& params);

  /// Seeds of the newest scan, most probable first. @param likelihood with the claims of all tracks.
  /// @param prior of the targets.
  std::span<const BirthSeed> propose(ScanLikelihood& likelihood, const TargetPrior& prior);

 private:
  struct Echo {
    Eigen::Vector2d position;
    int age = 0;
  };
  struct Score {
    double best = 0.0;  ///< Best log-likelihood ratio over windows.
    int oldest = 0;     ///< Age at which that window begins.
  };

  void collect_free_echoes(const ScanLikelihood& likelihood);
  void pair_echoes();
  void add_pair(const Echo& newest, const Echo& older, double seconds);
  void score(ScanLikelihood& likelihood, int oldest);
  void keep_best(std::size_t count);
  void refine_and_merge(const ScanLikelihood& likelihood);
  void weigh(ScanLikelihood& likelihood, int oldest);
  bool explained(const ScanLikelihood& likelihood, int age, std::size_t echo) const;
  bool refine(const ScanLikelihood& likelihood, std::size_t index, BirthSeed& seed) const;
  void add_members(const ScanLikelihood& likelihood, int age, const Eigen::Vector4d& state,
                   LineFit& fit) const;
  bool merged(const BirthSeed& seed);

  BirthParams params_;
  TargetPrior prior_;
  const ScanHistory* scans_ = nullptr;  ///< Of the call to `propose` that runs.
  std::vector<Echo> newest_, older_;
  TrajectoryCloud pairs_;
  std::vector<Score> scores_;
  std::vector<double> sum_, step_;
  int scored_to_ = -1;  ///< Age of the oldest scan in `sum_`.
  std::vector<std::size_t> order_;
  std::vector<BirthSeed> seeds_;
  TrajectoryCloud lines_;  ///< Of the seeds.
};

}  // namespace lookout::csht
