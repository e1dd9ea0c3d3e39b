#include "tools/experiments/experiment_registry.hpp"

#include <array>

#include "core/input_error.hpp"
#include "tools/experiments/fusion/t2gt.hpp"
#include "tools/experiments/fusion/two_uuv.hpp"
#include "tools/experiments/initiation/agfht_experiments.hpp"
#include "tools/experiments/initiation/initiator_sweeps.hpp"
#include "tools/experiments/initiation/nht_experiments.hpp"
#include "tools/experiments/initiation/recording_births.hpp"
#include "tools/experiments/initiation/sonar_births.hpp"
#include "tools/experiments/track_before_detect/hpmht_curves.hpp"
#include "tools/experiments/track_before_detect/hpmht_sonar.hpp"
#include "tools/experiments/track_before_detect/hpmht_video.hpp"
#include "tools/experiments/track_before_detect/image_sea.hpp"
#include "tools/experiments/tracking/csht_tracking.hpp"
#include "tools/experiments/tracking/faults.hpp"
#include "tools/experiments/tracking/limits.hpp"
#include "tools/experiments/tracking/manoeuvres.hpp"
#include "tools/experiments/tracking/radar_recordings.hpp"
#include "tools/experiments/tracking/sea.hpp"
#include "tools/experiments/tracking/sensors.hpp"
#include "tools/experiments/window/csht_ablation.hpp"
#include "tools/experiments/window/csht_window.hpp"

namespace lookout::tools {
namespace {

const std::array kExperiments{
    ExperimentEntry{"csht-window", make_csht_window},
    ExperimentEntry{"csht-ablation", make_csht_ablation},
    ExperimentEntry{"csht-tracking", make_csht_tracking},
    ExperimentEntry{"limits", make_limits},
    ExperimentEntry{"manoeuvres", make_manoeuvres},
    ExperimentEntry{"recordings", make_recordings},
    ExperimentEntry{"sea", make_sea},
    ExperimentEntry{"sensors", make_sensors},
    ExperimentEntry{"faults", make_faults},
    ExperimentEntry{"nht-simulated", make_nht_simulated},
    ExperimentEntry{"nht-real", make_nht_real},
    ExperimentEntry{"agfht-table2", make_agfht_table2},
    ExperimentEntry{"agfht-sweep", make_agfht_sweep},
    ExperimentEntry{"initiator-curves", make_initiator_curves},
    ExperimentEntry{"initiator-times", make_initiator_times},
    ExperimentEntry{"initiator-limits", make_initiator_limits},
    ExperimentEntry{"sonar-births", make_sonar_births},
    ExperimentEntry{"recording-births", make_recording_births},
    ExperimentEntry{"hpmht-video", make_hpmht_video},
    ExperimentEntry{"hpmht-sonar", make_hpmht_sonar},
    ExperimentEntry{"hpmht-curves", make_hpmht_curves},
    ExperimentEntry{"image-sea", make_image_sea},
    ExperimentEntry{"t2gt", make_t2gt},
    ExperimentEntry{"two-uuv", make_two_uuv},
};

}  // namespace

std::span<const ExperimentEntry> experiment_registry() {
  return kExperiments;
}

std::unique_ptr<Experiment> make_experiment(const std::string& name) {
  std::string names;
  for (const auto& entry : kExperiments) {
    if (entry.name == name) return entry.make();
    names += std::string(names.empty() ? "" : " ") + entry.name;
  }
  throw core::InputError("experiment `" + name + "` is not known, expected one of: " + names);
}

}  // namespace lookout::tools
