// Source: Liu, Liu, Xiong, improved Hough transform with a motion prior, 2016, as described by [Fan2018]
// section V.
#include "tracking/initiation/methods/iht_ti.hpp"

#include "tracking/initiation/methods/mht_ti.hpp"

namespace lookout::tracking {

std::unique_ptr<Initiator> make_iht_ti(const InitiatorConfig& config) {
  chosen_variant(config, "iht_ti", {});
  return std::make_unique<PairVotingInitiator>(line_voting_params(config), speed_limits(config, kFanSpeeds));
}

}  // namespace lookout::tracking
