#include "csht/estimator_registry.hpp"

#include <stdexcept>
#include <utility>

#include "core/files/yaml_reader.hpp"
#include "core/name_table.hpp"
#include "csht/baselines/csht_printed_estimator.hpp"
#include "csht/baselines/ransac_estimator.hpp"
#include "csht/baselines/sht_estimator.hpp"
#include "csht/csht_estimator.hpp"
#include "csht/engine_fields.hpp"
#include "csht/joint/joint_estimator.hpp"

namespace lookout::csht {
namespace {

constexpr core::Range kWindowScans{3, 100};

/// On raw images, in place of the whole chain (tracking/track_before_detect): a name that no estimator has.
constexpr const char* kImageEstimator = "h_pmht";

struct Entry {
  std::string name;
  MakeEstimator make;
};

std::unique_ptr<MotionEstimator> make_csht(const EstimatorParams& params, const core::SonarParams& sonar,
                                           std::uint64_t) {
  CshtParams csht = params.use == EstimatorUse::window ? CshtParams::window() : CshtParams::tracking();
  csht.window_scans = params.window_scans;
  csht.first_estimate_scans = params.first_estimate_scans;
  return std::make_unique<CshtEstimator>(csht, sonar);
}

std::unique_ptr<MotionEstimator> make_joint(const EstimatorParams& params, const core::SonarParams& sonar,
                                            std::uint64_t seed) {
  JointEstimatorParams joint =
      params.use == EstimatorUse::window ? JointEstimatorParams::window() : JointEstimatorParams{};
  joint.window_scans = params.window_scans;
  joint.first_estimate_scans = params.first_estimate_scans;
  core::ParameterList engine;
  list_fields(engine, "", joint.engine);
  for (const auto& [path, value] : params.engine)
    if (engine.has(path)) engine.set(path, value);
  return std::make_unique<JointEstimator>(joint, sonar, seed);
}

template <typename Params, typename Estimator>
std::unique_ptr<MotionEstimator> make_baseline(const EstimatorParams& params, const core::SonarParams& sonar,
                                               std::uint64_t) {
  Params own;
  own.window_scans = params.window_scans;
  own.first_estimate_scans = params.first_estimate_scans;
  return std::make_unique<Estimator>(own, sonar);
}

std::unique_ptr<MotionEstimator> make_ransac(const EstimatorParams& params, const core::SonarParams& sonar,
                                             std::uint64_t seed) {
  RansacParams ransac;
  ransac.window_scans = params.window_scans;
  ransac.first_estimate_scans = params.first_estimate_scans;
  return std::make_unique<RansacEstimator>(ransac, sonar, seed);
}

/// One line an estimator; those from outside follow.
core::NameTable<Entry>& registry() {
  static core::NameTable<Entry> entries(
      "estimator", {
                       {"joint", make_joint},
                       {"csht", make_csht},
                       {"csht_printed", make_baseline<CshtPrintedParams, CshtPrintedEstimator>},
                       {"sht", make_baseline<ShtParams, ShtEstimator>},
                       {"ransac", make_ransac},
                   });
  return entries;
}

void validate(const EstimatorParams& params) {
  if (params.window_scans < kWindowScans.min || params.window_scans > kWindowScans.max)
    throw std::invalid_argument("window_scans must be 3 to 100, got " + std::to_string(params.window_scans));
  if (params.first_estimate_scans < kWindowScans.min || params.first_estimate_scans > params.window_scans)
    throw std::invalid_argument("first_estimate_scans must be 3 to window_scans, got " +
                                std::to_string(params.first_estimate_scans));
}

}  // namespace

void register_estimator(const std::string& name, MakeEstimator make) {
  registry().add({name, std::move(make)}, {kImageEstimator});
}

void read_estimator_params(const core::YamlMap& map, EstimatorParams& params) {
  std::vector<std::string> names = estimator_names();
  names.emplace_back(kImageEstimator);
  params.name = map.choice("name", params.name, names);
  params.window_scans = map.integer("window_scans", params.window_scans, kWindowScans);
  const core::Range first_scans{kWindowScans.min, static_cast<double>(params.window_scans)};
  params.first_estimate_scans = map.integer("first_estimate_scans", params.first_estimate_scans, first_scans);
  map.finish();
}

std::vector<std::string> estimator_names() {
  return registry().names();
}

std::unique_ptr<MotionEstimator> make_estimator(const std::string& name, const EstimatorParams& params,
                                                const core::SonarParams& sonar, std::uint64_t seed) {
  validate(params);
  return registry().at(name).make(params, sonar, seed);
}

}  // namespace lookout::csht
