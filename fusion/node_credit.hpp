#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

namespace lookout::fusion {

/// What the word of one node is worth while no other says the same. All own choices.
struct NodeCreditParams {
  double prior_tracks = 10.0;  ///< So many tracks, > 0, are believed of a node before any is heard of it.
  double memory = 50.0;        ///< Newest outcomes that count, >= 1.
  double least = 0.5;     ///< A node with less credit, in [0, 1], begins no track that has not proved itself.
  double proof = 10.0;    ///< A track that goes on for so long [s], > 0, has proved itself.
  int max_unproved = 20;  ///< Tracks of one node that have not, at one time, >= 1.
};

/// How often what a node said alone came true. Every track that one node begins has an outcome: it is proved
/// when another node speaks for it or when it lasts, it was false when it ends before. A node whose tracks
/// prove false loses credit, and with it the right to begin tracks on its word; what it sends must prove
/// itself first. A node that is mended earns it back.
class NodeCredit {
 public:
  /// @param trust credit of a node that nothing is known of, in (0, 1); none has more.
  /// @throws std::invalid_argument on a parameter out of range.
  NodeCredit(const NodeCreditParams& params, double trust);

  /// Probability that a track which the node alone speaks for is a target, at most `trust`.
  double of(std::int32_t node_id) const;
  /// Whether a track that the node has sent for `life` [s] may begin on its word.
  bool may_begin(std::int32_t node_id, double life) const;
  double proof() const { return params_.proof; }  ///< See NodeCreditParams [s].

  void note_begun(std::int32_t node_id);      ///< It has begun a track, as yet unproved.
  void note_proved(std::int32_t node_id);     ///< One of those has proved itself,
  void note_false(std::int32_t node_id);      ///< has ended before it could,
  void note_undecided(std::int32_t node_id);  ///< or has become one with another.
  void forget_unproved();                     ///< No track is left; what was learnt stays.

  static constexpr std::size_t kMostNodes = 256;  ///< Of them the memory is kept.

 private:
  struct Record {
    double proved = 0.0, proved_false = 0.0;
    int unproved = 0;
  };
  Record& record(std::int32_t node_id);
  void settle(std::int32_t node_id, double proved, double proved_false);

  NodeCreditParams params_;
  double trust_;
  std::map<std::int32_t, Record> records_;
};

}  // namespace lookout::fusion
