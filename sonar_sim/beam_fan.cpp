#include "sonar_sim/beam_fan.hpp"

#include <algorithm>
#include <utility>

#include "core/parameter_check.hpp"

namespace lookout::sonar_sim {

BeamFan::BeamFan(const core::SonarParams& params, std::vector<double> centres)
    : params_(params), centres_(std::move(centres)) {
  if (centres_.empty()) return;
  core::require(static_cast<int>(centres_.size()) == params.num_beams,
                "beam centres must be as many as num_beams", static_cast<double>(centres_.size()));
  for (std::size_t beam = 1; beam < centres_.size(); ++beam) {
    core::require(centres_[beam] > centres_[beam - 1], "beam centres must increase", centres_[beam]);
    edges_.push_back(0.5 * (centres_[beam - 1] + centres_[beam]));
  }
}

double BeamFan::centre(int beam) const {
  return centres_.empty() ? params_.beam_centre(beam) : centres_[static_cast<std::size_t>(beam)];
}

int BeamFan::beam_of(double bearing) const {
  const int even_beam = params_.beam_of(bearing);
  if (centres_.empty() || even_beam < 0) return even_beam;
  const double middle = 0.5 * (params_.left_edge() + params_.right_edge());
  const double unwrapped = middle + core::wrap_to_pi(bearing - middle);
  return static_cast<int>(std::upper_bound(edges_.begin(), edges_.end(), unwrapped) - edges_.begin());
}

}  // namespace lookout::sonar_sim
