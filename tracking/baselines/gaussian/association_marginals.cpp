#include "tracking/baselines/gaussian/association_marginals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lookout::tracking {
namespace {

constexpr int kMostRounds = 100;   // Of belief propagation; it has settled long before.
constexpr double kSettled = 1e-6;  // Largest change of a message that counts as settled.

}  // namespace

void AssociationMarginals::solve(std::span<const AssociationPair> pairs, int num_tracks, int num_returns) {
  pairs_ = pairs;
  first_.assign(static_cast<std::size_t>(num_tracks) + 1, 0);
  for (const auto& pair : pairs) ++first_[static_cast<std::size_t>(pair.track) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  pair_.assign(pairs.size(), 0.0);
  missed_.assign(static_cast<std::size_t>(num_tracks), 0.0);
  unclaimed_.assign(static_cast<std::size_t>(num_returns), 1.0);
  used_.assign(static_cast<std::size_t>(num_returns), 0);
  cluster(num_tracks, num_returns);
  for (std::size_t begin = 0, end = 0; begin < order_.size(); begin = end) {
    while (end < order_.size() && root(order_[end]) == root(order_[begin])) ++end;
    const std::span<const int> tracks(order_.data() + begin, end - begin);
    num_events(tracks) <= most_events_ ? solve_exactly(tracks) : propagate(tracks);
  }
  for (std::size_t k = 0; k < pairs.size(); ++k)
    unclaimed_[static_cast<std::size_t>(pairs[k].detection)] -= pair_[k];
  for (double& share : unclaimed_) share = std::max(share, 0.0);
}

int AssociationMarginals::root(int node) {
  auto index = static_cast<std::size_t>(node);
  while (parent_[index] != static_cast<int>(index)) {
    parent_[index] = parent_[static_cast<std::size_t>(parent_[index])];
    index = static_cast<std::size_t>(parent_[index]);
  }
  return static_cast<int>(index);
}

// Tracks that share a return, directly or through others, are one cluster.
void AssociationMarginals::cluster(int num_tracks, int num_returns) {
  parent_.resize(static_cast<std::size_t>(num_tracks) + static_cast<std::size_t>(num_returns));
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const auto& pair : pairs_) {
    const int track = root(pair.track);
    parent_[static_cast<std::size_t>(track)] = root(num_tracks + pair.detection);
  }
  order_.resize(static_cast<std::size_t>(num_tracks));
  std::iota(order_.begin(), order_.end(), 0);
  roots_.resize(order_.size());
  for (int track = 0; track < num_tracks; ++track) roots_[static_cast<std::size_t>(track)] = root(track);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) {
    const int root_a = roots_[static_cast<std::size_t>(a)], root_b = roots_[static_cast<std::size_t>(b)];
    return root_a != root_b ? root_a < root_b : a < b;
  });
}

std::span<const AssociationPair> AssociationMarginals::pairs_of(int track) const {
  return pairs_.subspan(first_of(track), first_of(track + 1) - first_of(track));
}

double AssociationMarginals::num_events(std::span<const int> tracks) const {
  double product = 1.0;
  for (const int track : tracks) product *= 1.0 + static_cast<double>(pairs_of(track).size());
  return product;
}

void AssociationMarginals::solve_exactly(std::span<const int> tracks) {
  const double total = sum_events(tracks, 1.0);
  for (const int track : tracks) {
    missed_[static_cast<std::size_t>(track)] /= total;
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) pair_[k] /= total;
  }
}

// Goes through all events of these tracks, given what the tracks before them chose, whose weight is `weight`;
// adds each choice's share to the marginals. @return the weight of all these events together.
double AssociationMarginals::sum_events(std::span<const int> tracks, double weight) {
  if (tracks.empty()) return weight;
  const int track = tracks.front();
  const auto rest = tracks.subspan(1);
  double total = sum_events(rest, weight);
  missed_[static_cast<std::size_t>(track)] += total;
  for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) {
    char& used = used_[static_cast<std::size_t>(pairs_[k].detection)];
    if (used) continue;
    used = 1;
    const double sum = sum_events(rest, weight * pairs_[k].ratio);
    used = 0;
    pair_[k] += sum;
    total += sum;
  }
  return total;
}

// [Williams2014]: messages from tracks to returns and back until they settle.
void AssociationMarginals::propagate(std::span<const int> tracks) {
  to_return_.resize(pairs_.size());
  to_track_.resize(pairs_.size());
  at_return_.resize(unclaimed_.size());
  for (const int track : tracks)
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) to_track_[k] = 1.0;
  double change = 1.0;
  for (int round = 0; round < kMostRounds && change > kSettled; ++round) {
    send_to_returns(tracks);
    change = send_to_tracks(tracks);
  }
  for (const int track : tracks) {
    double sum = 1.0;
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) sum += pairs_[k].ratio * to_track_[k];
    missed_[static_cast<std::size_t>(track)] = 1.0 / sum;
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k)
      pair_[k] = pairs_[k].ratio * to_track_[k] / sum;
  }
}

void AssociationMarginals::send_to_returns(std::span<const int> tracks) {
  for (const int track : tracks)
    for (const auto& pair : pairs_of(track)) at_return_[static_cast<std::size_t>(pair.detection)] = 1.0;
  for (const int track : tracks) {
    double sum = 1.0;
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) sum += pairs_[k].ratio * to_track_[k];
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) {
      to_return_[k] = pairs_[k].ratio / std::max(sum - pairs_[k].ratio * to_track_[k], 1.0);
      at_return_[static_cast<std::size_t>(pairs_[k].detection)] += to_return_[k];
    }
  }
}

double AssociationMarginals::send_to_tracks(std::span<const int> tracks) {
  double change = 0.0;
  for (const int track : tracks) {
    for (std::size_t k = first_of(track); k < first_of(track + 1); ++k) {
      const double others = at_return_[static_cast<std::size_t>(pairs_[k].detection)] - to_return_[k];
      const double message = 1.0 / std::max(others, 1.0);
      change = std::max(change, std::abs(message - to_track_[k]));
      to_track_[k] = message;
    }
  }
  return change;
}

}  // namespace lookout::tracking
