#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/random.hpp"
#include "core/sonar_image.hpp"
#include "sonar_sim/image/standing_echoes.hpp"
#include "sonar_sim/image/target_strength.hpp"
#include "sonar_sim/image_model.hpp"
#include "sonar_sim/random_streams.hpp"
#include "sonar_sim/scene.hpp"
#include "sonar_sim/sea/standing_things.hpp"

namespace lookout::sonar_sim {

/// The images of one sonar, ping by ping: echoes of targets and of what stands, over the background of its
/// sea, through its receiver. Each part draws from a stream of its own, so that switching one on leaves the
/// draws of all others as they are.
class ImageMaker {
 public:
  /// @param sonar whose beams, even or not, and whose sea's standing things the image shows.
  /// @throws std::invalid_argument on a plan out of range.
  ImageMaker(const SonarPlan& sonar, const ImagePlan& plan, const StreamKey& key);

  /// The image of the visible targets of `truth`, at its time: echoes with a uniform phase at each ping,
  /// added as complex amplitudes to the background. Intensities are whole steps of an instrument of
  /// plan.bits, with 16 of them those of a message.
  /// @param snr_db of each target of `truth`, in its order.
  core::SonarImage draw(const core::Pose2& T_earth_sonar, const core::GroundTruth& truth,
                        const std::vector<double>& snr_db);

 private:
  using Field = std::vector<std::complex<double>>;
  void add_targets(const core::SonarImage& image, const core::Pose2& T_earth_sonar,
                   const core::GroundTruth& truth, const std::vector<double>& snr_db, Field& field);
  void add_standing(const core::SonarImage& image, std::span<const StandingScatterer> scatterers,
                    Field& field);
  std::vector<double> background_levels(const core::SonarImage& image,
                                        std::span<const StandingScatterer> scatterers) const;
  void receive(const Field& field, core::SonarImage& image) const;

  core::SonarParams sonar_;
  ImagePlan plan_;
  core::SonarImage empty_;
  StandingPlan standing_;  ///< Its fields' points placed.
  core::Random random_, standing_random_;
  std::optional<TargetStrength> strength_;
  std::vector<double> gains_;  ///< By beam; empty: all 1.
};

}  // namespace lookout::sonar_sim
