#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/sliding_initiator.hpp"
#include "tracking/initiation/sonar_plots.hpp"

namespace lookout::tracking {

/// What suits a sonar where `config` leaves it open: its speeds and errors, a window that is long enough to
/// measure a velocity, cells in proportion to the range error, few false tracks. The defaults of the papers
/// are those of radars and of targets at hundreds of metres a second.
InitiatorConfig for_sonar(const core::SonarParams& sonar, const std::string& initiator,
                          InitiatorConfig config);

/// Any registered initiator as the birth method of a tracker: it looks at the plots of the latest scans that
/// no track explains, around the sonar's place at the first of them, and proposes each started track once.
class InitiatorBirth : public BirthMethod {
 public:
  /// @param sonar its errors; the geometry of each scan wins over it.
  /// @throws std::invalid_argument on an unknown name or a value out of range.
  InitiatorBirth(const std::string& initiator, const InitiatorConfig& config, const core::SonarParams& sonar);

  std::span<const core::MotionElement> propose(const core::PosedScan& scan,
                                               std::span<const core::Track> tracks) override;

 private:
  bool explained(const Plot& plot, std::span<const core::Track> tracks) const;
  core::MotionElement element_of(const StartedTracks& started, const StartedTrack& track,
                                 const core::PosedScan& scan) const;

  core::SonarParams sonar_;
  std::unique_ptr<SlidingInitiator> sliding_;
  double gate_;
  std::int64_t first_utime_ = 0;  ///< Zero of the plots' time [us].
  bool has_begun_ = false;
  SonarPlots sonar_plots_;
  std::vector<Plot> plots_;  ///< Those that no track explains.
  std::vector<core::MotionElement> elements_;
};

/// The birth method that a tracker's configuration names, or nothing for an empty name and for `own`, the
/// tracker's.
std::unique_ptr<BirthMethod> make_birth(const std::string& initiator, const std::string& own,
                                        const InitiatorConfig& config, const core::SonarParams& sonar);

}  // namespace lookout::tracking
