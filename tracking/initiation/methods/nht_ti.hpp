// Source: Fan, Xie, Pei, Hu, Li, "Neutrosophic Hough Transform-Based Track Initiation ...", IEEE Access,
// 2018.
#pragma once

#include <memory>

#include "tracking/initiation/methods/mht_ti.hpp"

namespace lookout::tracking {

/// Which cells a pair votes for.
enum class NhtVote {
  cell,   ///< Its own alone: Eq. (23), (31) to the letter.
  spread  ///< All of its neighbourhood, with the membership of Eq. (15): the abstract; the only one that
          ///< gives the paper's Table 2.
};

/// Of the new Hough transform of temporary tracks. [Fan2018] section III.
struct NhtTiParams {
  LineVotingParams lines;                 ///< Of the votes and the peaks.
  SpeedLimits speeds = kFanSpeeds;        ///< Of a pair of plots.
  NhtVote vote = NhtVote::spread;         ///< Where a pair votes.
  bool chained = false;                   ///< A kernel counts only for pairs that begin at its newer plot.
  double false_alarm_probability = 0.01;  ///< P_F, in [0, 1). [Fan2018] section V.
  double false_degree_factor = 1.0;       ///< lambda_k of Eq. (29), >= 0; the paper gives no value.
  double least_vote = 1e-3;               ///< Weaker votes are left out, >= 0.
};

/// The neutrosophic Hough transform: a pair of plots votes as strongly as the pairs of the step before agree
/// with it: the largest of its degrees of true, uncertain and false association. Cost: pairs x (pairs of the
/// step before with nearly the same theta + cells of the neighbourhood). Refuses windows of more than
/// `kMaxPairs` pairs.
class NhtTiInitiator : public PairVotingInitiator {
 public:
  static constexpr std::int64_t kMaxPairs = 200'000;  ///< About a second.

  /// @throws std::invalid_argument on a value out of range.
  explicit NhtTiInitiator(const NhtTiParams& params);

 private:
  void begin_window() override { kernels_.clear(); }
  void take_step(const std::vector<PairPoint>& step) override;
  double degree_of(const PairPoint& pair);
  void spread_vote(const NormalLine& line, double weight);
  double membership(const NormalLine& apart) const;

  NhtTiParams params_;
  std::vector<PairPoint> kernels_;     ///< Pairs of the step before, by rising theta.
  std::vector<NormalLine> competing_;  ///< Kernels around the pair at hand, relative to it.
  std::vector<double> row_membership_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kNhtTiKeys{
    "variant",        "min_speed",     "max_speed",           "gate_margin",    "rho_step",
    "theta_step_deg", "rho_tolerance", "theta_tolerance_deg", "peak_threshold", "min_plots",
    "max_tracks",     "window_scans",  "acceleration_sigma"};

/// Keys: `min_speed`, `max_speed`, `gate_margin` and those of LineVotingParams. Variants: `spread` (default),
/// `cell`, `spread_chained`, `cell_chained`.
std::unique_ptr<Initiator> make_nht_ti(const InitiatorConfig& config);

}  // namespace lookout::tracking
