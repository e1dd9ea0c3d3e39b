#include "tracking/tracker_registry.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "core/files/yaml_reader.hpp"
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

std::unique_ptr<Tracker> make_kalman(const TrackerParams& params, const core::SonarParams& sonar,
                                     std::uint64_t /*seed*/) {
  KalmanParams kalman;
  kalman.life.coast_s = params.coast_s;
  auto births = make_birth(params.initiator, "kalman", params.births, sonar);
  if (births != nullptr) confirm_at_birth(kalman.life);
  set_own(params, "kalman", kalman);
  return std::make_unique<KalmanTracker>(kalman, sonar, std::move(births));
}

std::unique_ptr<Tracker> make_gnn(const TrackerParams& params, const core::SonarParams& sonar,
                                  std::uint64_t /*seed*/) {
  GnnParams gnn;
  gnn.life.coast_s = params.coast_s;
  auto births = make_birth(params.initiator, "gnn", params.births, sonar);
  if (births != nullptr) confirm_at_birth(gnn.life);
  set_own(params, "gnn", gnn);
  return std::make_unique<GnnTracker>(gnn, sonar, std::move(births));
}

/// These begin tracks by probabilities that an initiator does not state.
void refuse_initiator(const TrackerParams& params, const std::string& tracker) {
  if (params.initiator.empty() || params.initiator == tracker) return;
  throw std::invalid_argument("tracker: initiator: `" + params.initiator + "` has no effect on tracker " +
                              tracker + ", which begins tracks by its own births; expected " + tracker +
                              " or none");
}

std::unique_ptr<Tracker> make_jipda(const TrackerParams& params, const core::SonarParams& sonar,
                                    std::uint64_t /*seed*/) {
  refuse_initiator(params, "jipda");
  JipdaParams jipda;
  jipda.existence.coast_s = params.coast_s;
  set_own(params, "jipda", jipda);
  return std::make_unique<JipdaTracker>(jipda, sonar);
}

std::unique_ptr<Tracker> make_gm_phd(const TrackerParams& params, const core::SonarParams& sonar,
                                     std::uint64_t /*seed*/) {
  refuse_initiator(params, "gm_phd");
  GmPhdParams gm_phd;
  gm_phd.existence.coast_s = params.coast_s;
  set_own(params, "gm_phd", gm_phd);
  return std::make_unique<GmPhdTracker>(gm_phd, sonar);
}

std::unique_ptr<Tracker> make_pmbm(const TrackerParams& params, const core::SonarParams& sonar,
                                   std::uint64_t /*seed*/) {
  refuse_initiator(params, "pmbm");
  PmbmParams pmbm;
  pmbm.existence.coast_s = params.coast_s;
  set_own(params, "pmbm", pmbm);
  return std::make_unique<PmbmTracker>(pmbm, sonar);
}

/// One line a tracker; those from outside follow.
std::vector<Entry>& registry() {
  static std::vector<Entry> entries{
      {"joint", "joint", &make_joint, &listed<JointTrackerParams>},
      {"csht", "csht", &make_csht, &listed<CshtTrackerParams>},
      {"kalman", "", &make_kalman, &listed<KalmanParams>},
      {"gnn", "", &make_gnn, &listed<GnnParams>},
      {"jipda", "", &make_jipda, &listed<JipdaParams>},
      {"gm_phd", "", &make_gm_phd, &listed<GmPhdParams>},
      {"pmbm", "", &make_pmbm, &listed<PmbmParams>},
  };
  return entries;
}

bool is_name(const std::string& text) {
  const auto is_part = [](unsigned char letter) { return std::isalnum(letter) != 0 || letter == '_'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_part);
}

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
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
  if (!is_name(name))
    throw std::invalid_argument("a tracker's name must be letters, digits and underscores, got `" + name +
                                "`");
  if (is_one_of(name, tracker_names()) || is_one_of(name, initiator_names()))
    throw std::invalid_argument("the tracker or initiator `" + name + "` exists already");
  if (!estimator.empty() && !is_one_of(estimator, csht::estimator_names()))
    throw std::invalid_argument("the estimator `" + estimator + "` of tracker `" + name + "` is not known");
  if (make == nullptr)
    throw std::invalid_argument("the tracker `" + name + "` has no function that makes it");
  registry().push_back({name, estimator, std::move(make)});
}

ListedParameters own_parameters(const std::string& tracker) {
  for (const auto& entry : registry())
    if (entry.name == tracker && entry.own != nullptr) return entry.own();
  return {};
}

std::vector<std::string> tracker_names() {
  std::vector<std::string> names;
  for (const auto& entry : registry()) names.emplace_back(entry.name);
  return names;
}

std::string default_estimator(const std::string& tracker) {
  for (const auto& entry : registry())
    if (entry.name == tracker) return entry.estimator;
  return {};
}

std::unique_ptr<Tracker> make_tracker(const std::string& name, const TrackerParams& params,
                                      const core::SonarParams& sonar, std::uint64_t seed) {
  std::string accepted;
  for (const auto& entry : registry()) {
    if (entry.name == name) return entry.make(params, sonar, seed);
    accepted += " " + entry.name;
  }
  throw std::invalid_argument("tracker must be one of" + accepted + ", got `" + name + "`");
}

}  // namespace lookout::tracking
