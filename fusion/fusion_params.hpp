#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fusion/estimate_limits.hpp"
#include "fusion/fusion_clock.hpp"
#include "fusion/global_tracks.hpp"
#include "fusion/learned_geometry.hpp"
#include "fusion/local_track_store.hpp"
#include "fusion/methods/central_kalman_fusion.hpp"
#include "fusion/methods/support_degree_fusion.hpp"
#include "fusion/track_association.hpp"
#include "tracking/node/local_estimate_sender.hpp"

namespace lookout::core {
class YamlMap;
}

namespace lookout::fusion {

/// Everything that the fusion node can be told, nested by stage.
struct FusionParams {
  std::string method = "learned";            ///< One of `fusion_method_names()`.
  EstimateLimits limits;                     ///< Which messages are plausible.
  FusionClockParams clock;                   ///< Of the nodes' common time.
  LocalTrackStoreParams store;               ///< Which local tracks are kept.
  AssociationParams association;             ///< Which tracklets are one target.
  SupportDegreeParams support_degree;        ///< Of `sdf` and `sdf_fixed`.
  LearnedGeometryParams learned;             ///< Of `learned`.
  KalmanModel kalman;                        ///< Of `central` and `ml`.
  GlobalTracksParams global;                 ///< Which global tracks begin and end.
  tracking::LocalEstimateSenderParams link;  ///< Of each node, for `lookout track --publish-estimates`.
};

/// Overrides `params` with the keys of the `fusion:` part of a configuration, and calls map.finish().
/// @throws core::InputError on an unknown key or a value out of range.
void read_fusion_params(const core::YamlMap& map, FusionParams& params);

/// sdf sdf_fixed dw_a dw_b dw_c dw_d mean single icov ci ci_trace ml central learned.
const std::vector<std::string>& fusion_method_names();

/// @throws std::invalid_argument naming the accepted methods where params.method is none of them, or a
/// parameter out of range.
std::unique_ptr<FusionMethod> make_fusion_method(const FusionParams& params);

}  // namespace lookout::fusion
