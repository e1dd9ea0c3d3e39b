#pragma once

#include <span>
#include <vector>

#include "tracking/association/k_best_assignments.hpp"
#include "tracking/baselines/pmbm/track_tree.hpp"

namespace lookout::tracking {

/// How many global hypotheses are kept.
struct MixtureParams {
  int most_hypotheses = 100;      ///< Global hypotheses, >= 1.
  double least_weight = 1e-4;     ///< Weight below which a global hypothesis is dropped, in (0, 1).
  double least_existence = 1e-3;  ///< Existence below which a hypothesis has no such target, in (0, 1).

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// A multi-Bernoulli mixture: tracks with single-target hypotheses, and global hypotheses, each of which
/// chooses one of them, or none, for every track. A scan splits every global hypothesis by its best
/// assignments of returns to targets, found by Murty's method. [Williams2015], [GarciaFernandez2018]
class HypothesisMixture {
 public:
  explicit HypothesisMixture(const MixtureParams& params);  ///< One global hypothesis, of no track.

  /// A track's single-target hypothesis.
  struct Local {
    GaussianTarget target;   ///< Given that it exists.
    double existence = 0.0;  ///< Probability that it exists.
    bool detected = false;   ///< Whether the newest scan holds its return.
  };
  /// A track with its hypotheses, summed up over the global ones in `head`.
  struct Track {
    BernoulliTrack head;        ///< Identity, life, marginal existence and target.
    std::vector<Local> locals;  ///< Chosen by index.
  };
  static constexpr int kNone = -1;  ///< The track's target does not exist.
  /// A global hypothesis.
  struct Global {
    double weight = 1.0;      ///< Probability; those of all sum to 1.
    std::vector<int> choice;  ///< Of each track, one of its locals or kNone.
    std::vector<int> taken;   ///< Returns of the newest scan that its targets made.
  };

  std::span<Track> tracks() { return tracks_; }                 ///< In order of `add`.
  std::span<const Track> tracks() const { return tracks_; }     ///< The same, to read.
  std::span<const Global> globals() const { return globals_; }  ///< The heaviest first.

  /// Adds a track that is independent of all others; every global hypothesis is split by its hypotheses.
  void add(const TrackTree& tree);
  /// Forgets the tracks with a flag, one a track.
  void remove(const std::vector<char>& removed);
  /// Takes the track out as a tree of its marginal hypotheses.
  TrackTree marginal(std::size_t track) const;

  /// Carries all tracks to the scan and claims their returns in the view.
  void predict(const SwitchingMotion& motion, RivalScene& scene);
  /// Takes a scan in. @param others of each return: odds that it is a target's of no track here, over false.
  void update(const RivalScene& scene, std::span<const double> others);
  /// After `update`: probability that a return belongs to one of the tracks.
  double taken(std::size_t detection) const { return taken_[detection]; }

 private:
  /// What a local hypothesis may become.
  struct Options {
    double missed = 0.0;        // Weight of having no return.
    double existence = 0.0;     // Given no return.
    std::vector<double> ratio;  // Of each return in use: weight of having it, over `missed`.
    std::vector<int> child;     // Of each return in use, then of none: index of the new local, or kUnborn.
  };

  void find_returns_in_use(const RivalScene& scene);
  void weigh(const RivalScene& scene, std::span<const double> others);
  Options weigh(const Track& track, const Local& local, const RivalScene& scene) const;
  void split(const Global& global, const RivalScene& scene);
  double fill_cost(const Global& global);
  Global child_of(const Global& global, const RankedAssignment& assignment, const RivalScene& scene);
  int child_of(std::size_t track, int local, std::size_t in_use, const RivalScene& scene);
  void keep_heaviest();
  void merge_equal();
  void drop_unused_locals();
  void sum_up(const RivalScene& scene);

  MixtureParams params_;
  std::vector<Track> tracks_;
  std::vector<Global> globals_{Global{}};
  std::vector<double> taken_;

  KBestAssignments assignments_;
  Eigen::MatrixXd cost_;
  std::vector<std::size_t> rows_;                 // Tracks that exist in the hypothesis that is being split.
  std::vector<int> in_use_;                       // Returns in the gate of any local.
  std::vector<std::vector<Options>> options_;     // Of each track's locals.
  std::vector<std::vector<Local>> grown_locals_;  // Of each track.
  std::vector<Global> grown_;                     // Their weights are logarithms.
  std::vector<double> background_;  // Of each return: weight of being nobody's here, over false.
};

}  // namespace lookout::tracking
