#include "tracking/baselines/gaussian/rival_scene.hpp"

#include "core/field_of_view.hpp"
#include "core/frames.hpp"

namespace lookout::tracking {

RivalScene::RivalScene(const ScanViewParams& view, const PopulationParams& population,
                       const core::SonarParams& sonar)
    : sonar_(sonar), view_(view), undetected_(population, sonar), figures_(sonar) {}

void RivalScene::look(const core::PosedScan& scan) {
  seconds_ = started_ ? core::seconds(scan.scan.utime - utime_) : 0.0;
  started_ = true;
  utime_ = scan.scan.utime;
  view_.look(scan, core::with_geometry_of(scan.scan, sonar_), figures_.figures());
  undetected_.predict(seconds_, view_.field_area());
}

double RivalScene::birth_ratio(const ViewedReturn& seen) const {
  return undetected_.density() * view_.detection_probability() / seen.clutter_density;
}

double RivalScene::birth_existence(const ViewedReturn& seen, double free) const {
  const double ratio = birth_ratio(seen);
  return free * ratio / (1.0 + ratio);
}

void RivalScene::finish(const ScanTally& tally) {
  undetected_.miss(view_.detection_probability());
  figures_.learn(tally);
}

}  // namespace lookout::tracking
