#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fusion/fusion_clock.hpp"
#include "fusion/global_tracks.hpp"
#include "fusion/learned_geometry.hpp"
#include "fusion/estimate_limits.hpp"
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
  std::string method = "learned";  ///< One of `fusion_method_names()`.
  EstimateLimits limits;
  FusionClockParams clock;
  LocalTrackStoreParams store;
  AssociationParams association;
  SupportDegreeParams support_degree;
  LearnedGeometryParams learned;
  KalmanModel kalman;
  GlobalTracksParams global;
  tracking::LocalEstimateSenderParams link;  ///< Of each node, for `lookout track --publish-estimates`.
};

/// Overrides `params` with the keys of the `fusion:` part of a configuration, and calls map.finish().
/// @throws core::InputError on an unknown key or a value out of range.
void read_fusion_params(const core::YamlMap& map, FusionParams& params);

/// sdf sdf_fixed dw_a dw_b dw_c dw_d mean single icov ci ml central learned.
const std::vector<std::string>& fusion_method_names();

/// @throws std::invalid_argument naming the accepted methods where params.method is none of them, or a
/// parameter out of range.
std::unique_ptr<FusionMethod> make_fusion_method(const FusionParams& params);

}  // namespace lookout::fusion
