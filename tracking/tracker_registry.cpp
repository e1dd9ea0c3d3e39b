#include "tracking/tracker_registry.hpp"

#include <stdexcept>

#include "core/files/yaml_reader.hpp"
#include "tracking/baselines/gnn_tracker.hpp"
#include "tracking/baselines/kalman_tracker.hpp"
#include "tracking/csht_tracker.hpp"
#include "tracking/initiation/initiator_birth.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/joint/joint_tracker.hpp"

namespace lookout::tracking {
namespace {

using Factory = std::unique_ptr<Tracker> (*)(const TrackerParams&, const core::SonarParams&,
                                             std::uint64_t seed);

struct Entry {
  const char* name;
  const char* estimator;  ///< Where none is named; empty: it works on detections alone.
  Factory make;
};

/// A track that an initiator starts has shown its M of N already.
void confirm_at_birth(TrackLifeParams& life) {
  life.confirm_hits = 1;
  life.confirm_scans = 1;
}

std::unique_ptr<Tracker> make_csht(const TrackerParams& params, const core::SonarParams& sonar,
                                   std::uint64_t /*seed*/) {
  CshtTrackerParams csht;
  csht.life.coast_s = params.coast_s;
  csht.min_existence = params.min_existence;
  // Half the fastest target's speed: 1.5 m/s for the sonar's 3 m/s.
  csht.element_gate.velocity = 0.5 * sonar.max_speed;
  return std::make_unique<CshtTracker>(csht, sonar,
                                       make_birth(params.initiator, "csht", params.births, sonar));
}

std::unique_ptr<Tracker> make_joint(const TrackerParams& params, const core::SonarParams& sonar,
                                    std::uint64_t seed) {
  JointTrackerParams joint;
  joint.life.coast_s = params.coast_s;
  joint.report.report_all = params.report_all;
  joint.report.min_existence = joint.learning.least_existence = params.min_existence;
  return std::make_unique<JointTracker>(joint, sonar, seed,
                                        make_birth(params.initiator, "joint", params.births, sonar));
}

std::unique_ptr<Tracker> make_kalman(const TrackerParams& params, const core::SonarParams& sonar,
                                     std::uint64_t /*seed*/) {
  KalmanParams kalman;
  kalman.life.coast_s = params.coast_s;
  auto births = make_birth(params.initiator, "kalman", params.births, sonar);
  if (births != nullptr) confirm_at_birth(kalman.life);
  return std::make_unique<KalmanTracker>(kalman, sonar, std::move(births));
}

std::unique_ptr<Tracker> make_gnn(const TrackerParams& params, const core::SonarParams& sonar,
                                  std::uint64_t /*seed*/) {
  GnnParams gnn;
  gnn.life.coast_s = params.coast_s;
  auto births = make_birth(params.initiator, "gnn", params.births, sonar);
  if (births != nullptr) confirm_at_birth(gnn.life);
  return std::make_unique<GnnTracker>(gnn, sonar, std::move(births));
}

/// One line a tracker.
constexpr Entry kRegistry[] = {
    {"joint", "joint", &make_joint},
    {"csht", "csht", &make_csht},
    {"kalman", "", &make_kalman},
    {"gnn", "", &make_gnn},
};

}  // namespace

void read_tracker_params(const core::YamlMap& map, TrackerParams& params) {
  params.name = map.choice("name", params.name, tracker_names());
  params.coast_s = map.number("coast_s", params.coast_s, core::kNotNegative);
  std::vector<std::string> births = initiator_names();
  for (const auto& own : tracker_names()) births.push_back(own);
  params.initiator = map.choice("initiator", params.initiator, births);
  map.finish();
}

void read_output_params(const core::YamlMap& map, TrackerParams& params) {
  const auto threshold = map.optional_number("min_existence", core::kProbability);
  params.report_all = params.report_all || threshold.has_value();
  params.min_existence = threshold.value_or(params.min_existence);
  map.finish();
}

std::vector<std::string> tracker_names() {
  std::vector<std::string> names;
  for (const auto& entry : kRegistry) names.emplace_back(entry.name);
  return names;
}

std::string default_estimator(const std::string& tracker) {
  for (const auto& entry : kRegistry)
    if (entry.name == tracker) return entry.estimator;
  return {};
}

std::unique_ptr<Tracker> make_tracker(const std::string& name, const TrackerParams& params,
                                      const core::SonarParams& sonar, std::uint64_t seed) {
  std::string accepted;
  for (const auto& entry : kRegistry) {
    if (entry.name == name) return entry.make(params, sonar, seed);
    accepted += std::string(" ") + entry.name;
  }
  throw std::invalid_argument("tracker must be one of" + accepted + ", got `" + name + "`");
}

}  // namespace lookout::tracking
