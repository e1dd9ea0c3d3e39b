#include "tracking/tracker_registry.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/files/yaml_reader.hpp"
#include "core/name_table.hpp"
#include "csht/estimator_registry.hpp"
#include "tracking/baselines/gm_phd/gm_phd_tracker.hpp"
#include "tracking/baselines/gnn_tracker.hpp"
#include "tracking/baselines/jipda/jipda_tracker.hpp"
#include "tracking/baselines/kalman_tracker.hpp"
#include "tracking/baselines/pmbm/pmbm_tracker.hpp"
#include "tracking/csht_tracker.hpp"
#include "tracking/initiation/initiator_birth.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/joint/joint_tracker.hpp"
#include "tracking/tracker_fields.hpp"

namespace lookout::tracking {
namespace {

struct Entry {
  std::string name;
  std::string estimator;  ///< Where none is named; empty: it works on detections alone.
  MakeTracker make;
  ListedParameters (*own)() = nullptr;  ///< Null: no parameters of its own.
};

template <typename Params>
ListedParameters listed() {
  const auto params = std::make_shared<Params>();
  ListedParameters result{params, {}};
  list_fields(result.list, "", *params);
  return result;
}

/// Sets what the user chose of a tracker's own parameters.
template <typename Params>
void set_own(const TrackerParams& chosen, const std::string& tracker, Params& params) {
  const auto own = chosen.own.find(tracker);
  if (own == chosen.own.end()) return;
  core::ParameterList list;
  list_fields(list, "", params);
  list.set(own->second);
}

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
  set_own(params, "csht", csht);
  return std::make_unique<CshtTracker>(csht, sonar,
                                       make_birth(params.initiator, "csht", params.births, sonar));
}

std::unique_ptr<Tracker> make_joint(const TrackerParams& params, const core::SonarParams& sonar,
                                    std::uint64_t seed) {
  JointTrackerParams joint;
  joint.life.coast_s = params.coast_s;
  joint.report.report_all = params.report_all;
  joint.report.standing.report = params.report_standing;
  joint.report.min_existence = joint.learning.least_existence = params.min_existence;
  set_own(params, "joint", joint);
  return std::make_unique<JointTracker>(joint, sonar, seed,
                                        make_birth(params.initiator, "joint", params.births, sonar));
}

/// A tracker on single detections, which begins tracks on them or where an initiator says.
template <typename Params, typename OnDetections>
MakeTracker on_detections(const std::string& name) {
  return [name](const TrackerParams& params, const core::SonarParams& sonar, std::uint64_t /*seed*/) {
    Params own;
    own.life.coast_s = params.coast_s;
    auto births = make_birth(params.initiator, name, params.births, sonar);
    if (births != nullptr) confirm_at_birth(own.life);
    set_own(params, name, own);
    return std::make_unique<OnDetections>(own, sonar, std::move(births));
  };
}

/// These begin tracks by probabilities that an initiator does not state.
void refuse_initiator(const TrackerParams& params, const std::string& tracker) {
  if (params.initiator.empty() || params.initiator == tracker) return;
  throw std::invalid_argument("tracker: initiator: `" + params.initiator + "` has no effect on tracker " +
                              tracker + ", which begins tracks by its own births; expected " + tracker +
                              " or none");
}

/// A tracker whose tracks live by their existence.
template <typename Params, typename Rival>
MakeTracker by_existence(const std::string& name) {
  return [name](const TrackerParams& params, const core::SonarParams& sonar, std::uint64_t /*seed*/) {
    refuse_initiator(params, name);
    Params own;
    own.existence.coast_s = params.coast_s;
    set_own(params, name, own);
    return std::make_unique<Rival>(own, sonar);
  };
}

/// One line a tracker; those from outside follow.
core::NameTable<Entry>& registry() {
  static core::NameTable<Entry> entries(
      "tracker",
      {
          {"joint", "joint", &make_joint, &listed<JointTrackerParams>},
          {"csht", "csht", &make_csht, &listed<CshtTrackerParams>},
          {"kalman", "", on_detections<KalmanParams, KalmanTracker>("kalman"), &listed<KalmanParams>},
          {"gnn", "", on_detections<GnnParams, GnnTracker>("gnn"), &listed<GnnParams>},
          {"jipda", "", by_existence<JipdaParams, JipdaTracker>("jipda"), &listed<JipdaParams>},
          {"gm_phd", "", by_existence<GmPhdParams, GmPhdTracker>("gm_phd"), &listed<GmPhdParams>},
          {"pmbm", "", by_existence<PmbmParams, PmbmTracker>("pmbm"), &listed<PmbmParams>},
      });
  return entries;
}

}  // namespace

void read_tracker_params(const core::YamlMap& map, TrackerParams& params) {
  params.name = map.choice("name", params.name, tracker_names());
  params.coast_s = map.number("coast_s", params.coast_s, core::kNotNegative);
  std::vector<std::string> births = initiator_names();
  for (const auto& own : tracker_names()) births.push_back(own);
  params.initiator = map.choice("initiator", params.initiator, births);
  for (const auto& tracker : tracker_names())
    if (const auto part = map.map(tracker)) params.own[tracker] = own_parameters(tracker).list.read(*part);
  map.finish();
}

void read_output_params(const core::YamlMap& map, TrackerParams& params) {
  const auto threshold = map.optional_number("min_existence", core::kProbability);
  params.report_all = params.report_all || threshold.has_value();
  params.min_existence = threshold.value_or(params.min_existence);
  params.report_standing = map.flag("standing", params.report_standing);
  map.finish();
}

void register_tracker(const std::string& name, const std::string& estimator, MakeTracker make) {
  const std::vector<std::string> estimators = csht::estimator_names();
  if (!estimator.empty() && std::find(estimators.begin(), estimators.end(), estimator) == estimators.end())
    throw std::invalid_argument("the estimator `" + estimator + "` of tracker `" + name + "` is not known");
  registry().add({name, estimator, std::move(make)}, initiator_names());
}

ListedParameters own_parameters(const std::string& tracker) {
  const Entry* const entry = registry().find(tracker);
  return entry != nullptr && entry->own != nullptr ? entry->own() : ListedParameters{};
}

std::vector<std::string> tracker_names() {
  return registry().names();
}

std::string default_estimator(const std::string& tracker) {
  const Entry* const entry = registry().find(tracker);
  return entry != nullptr ? entry->estimator : std::string();
}

std::unique_ptr<Tracker> make_tracker(const std::string& name, const TrackerParams& params,
                                      const core::SonarParams& sonar, std::uint64_t seed) {
  return registry().at(name).make(params, sonar, seed);
}

}  // namespace lookout::tracking
