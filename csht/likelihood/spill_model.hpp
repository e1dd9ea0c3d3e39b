#pragma once

#include <array>
#include <span>
#include <vector>

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// How echoes that are heard in several beams are recognised and counted once.
struct SpillParams {
  bool enabled = true;         ///< Without it each return is evidence of its own.
  double memory_scans = 60.0;  ///< Over which the figures are learnt, > 1.
  double range_gate = 1.0;     ///< Returns of one echo differ by no more than this [range sigmas], > 0.
  double least_real = 0.3;     ///< Share of the coincidences at an offset that must be real, in (0, 1).
  double doubt_sigmas = 2.0;   ///< Chance coincidences are taken for so many sigmas more, >= 0.
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const SpillParams& params);

/// Spill: one echo reported by neighbouring beams too, at nearly the same range. How often is learnt by
/// offset, from coincidences beyond those of chance; returns that one echo may have made form a group, in
/// which each has the probability of being the echo's own beam. docs/clutter_map.md.
class SpillModel {
 public:
  static constexpr int kReach = 3;  ///< Largest offset [beams].

  /// @param params validated.
  explicit SpillModel(const SpillParams& params) : params_(params) { groups_.reserve(kMostGroups); }

  /// Counts the coincidences of a new scan: where clutter is dense, neighbours coincide by chance, and count
  /// less. @param false_alarm P_F of a beam. @param background of each slot, as ScanTable::background, before
  /// groups.
  void learn(const ScanTable& scan, double false_alarm, std::span<const float> background);
  /// Sets group and share of each slot's return; all alone, shares 1, while no spill is known. Sensors
  /// without beams have none. @param background as above.
  void group(std::span<const float> background, ScanTable& scan) const;

  /// Probability that an echo is heard so many beams off too, as far as known: 1 <= offset <= kReach.
  double probability(int offset) const;
  /// Share of the coincidences at an offset that are no chance; 0 where that is not sure.
  double real_share(int offset) const;
  bool active() const { return real_share(1) > 0.0; }  ///< Whether any spill is known.

 private:
  struct Offset {
    double hits = 0.0, chance = 0.0;   // Coincidences, and how many were to be expected.
    double heard = 0.0, echoes = 0.0;  // Of echoes, how many are heard so far off, and how many could be.
  };
  static constexpr std::size_t kMostGroups = 64;  // That memory is kept for; of more, the rest stays alone.
  static constexpr int kMostBeams = 7;  // Widest group that is taken for one echo; a wider one is none.
  struct Group {                        // Beams that may have heard one echo, in order.
    std::array<int, kMostBeams + 1> beam{};
    std::array<double, kMostBeams + 1> origin{};  // Probability that the echo is this beam's own.
    int size = 0;
    double real = 0.0;  // Probability that one echo made it.
    bool holds(int other) const;
  };
  void find_groups(const ScanTable& scan, std::span<const float> background,
                   std::vector<Group>& groups) const;
  Group group_from(const ScanTable& scan, int first) const;
  void weigh_origins(const ScanTable& scan, Group& group) const;
  double origin_weight(const ScanTable& scan, const Group& group, int beam) const;
  bool coincide(const ScanTable& scan, int a, int b) const;
  double real_of(const Group& group, std::span<const float> background) const;
  void learn_shares(const ScanTable& scan, std::span<const float> background);

  SpillParams params_;
  std::array<Offset, kReach + 1> offsets_{};
  mutable std::vector<Group> groups_;
  mutable std::vector<char> taken_;  ///< Beams that are in a group already.
};

}  // namespace lookout::csht
