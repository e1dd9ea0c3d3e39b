#pragma once

#include <span>
#include <vector>

namespace lookout::tracking {

/// A return that may belong to a track.
struct AssociationPair {
  int track = 0;       ///< Index of the track.
  int detection = 0;   ///< Index of the return.
  double ratio = 0.0;  ///< Weight of the pair over the weight of both without each other, > 0.
};

/// With which probability each return belongs to each track, where a track has at most one return and a
/// return at most one track: summed over all joint events of a cluster of tracks that share returns, or,
/// where these are too many, by belief propagation. [Musicki2004] for the sum, [Williams2014] for the rest.
class AssociationMarginals {
 public:
  /// @param most_events above which a cluster is solved by belief propagation.
  explicit AssociationMarginals(double most_events) : most_events_(most_events) {}

  /// @param pairs in the order of their tracks.
  void solve(std::span<const AssociationPair> pairs, int num_tracks, int num_returns);

  double pair(std::size_t index) const { return pair_[index]; }                        ///< Of `pairs[index]`.
  double missed(int track) const { return missed_[static_cast<std::size_t>(track)]; }  ///< It has no return.
  /// The return belongs to no track.
  double unclaimed(int detection) const { return unclaimed_[static_cast<std::size_t>(detection)]; }

 private:
  int root(int node);
  void cluster(int num_tracks, int num_returns);
  void solve_exactly(std::span<const int> tracks);
  double sum_events(std::span<const int> tracks, double weight);
  void propagate(std::span<const int> tracks);
  void send_to_returns(std::span<const int> tracks);
  double send_to_tracks(std::span<const int> tracks);
  std::span<const AssociationPair> pairs_of(int track) const;
  std::size_t first_of(int track) const { return first_[static_cast<std::size_t>(track)]; }
  double num_events(std::span<const int> tracks) const;

  double most_events_;
  std::span<const AssociationPair> pairs_;
  std::vector<std::size_t> first_;  // Of each track: its first pair; one more at the end.
  std::vector<int> parent_;         // Of the union of tracks, then returns.
  std::vector<int> roots_, order_;  // Of the tracks: their cluster; the tracks, cluster by cluster.
  std::vector<char> used_;          // Of each return, in the event that is being summed.
  std::vector<double> to_return_, to_track_, at_return_;  // Messages of the pairs; sums at the returns.
  std::vector<double> pair_, missed_, unclaimed_;
};

}  // namespace lookout::tracking
