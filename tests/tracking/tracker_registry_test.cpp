#include "tracking/tracker_registry.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"

namespace lookout::tracking {
namespace {

TEST(TrackerRegistry, MakesEveryNameItShows) {
  for (const auto& name : tracker_names()) EXPECT_NE(make_tracker(name, {}, {}, 1), nullptr) << name;
}

TEST(TrackerRegistry, NamesWhatItAccepts) {
  try {
    make_tracker("nothing", {}, {}, 1);
    FAIL() << "an unknown name was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("gnn"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("`nothing`"), std::string::npos);
  }
}

TEST(TrackerRegistry, ReadsItsPartsOfAConfiguration) {
  TrackerParams params;
  read_tracker_params(core::YamlMap::load_text("{name: gnn, coast_s: 3.5}", "t"), params);
  read_output_params(core::YamlMap::load_text("{min_existence: 0.7}", "t"), params);
  EXPECT_EQ(params.name, "gnn");
  EXPECT_EQ(params.coast_s, 3.5);
  EXPECT_EQ(params.min_existence, 0.7);
  EXPECT_TRUE(params.report_all);
}

TEST(TrackerRegistry, RefusesBadConfigurations) {
  TrackerParams params;
  for (const char* text : {"{name: best}", "{coast_s: -1}", "{window: 20}"})
    EXPECT_THROW(read_tracker_params(core::YamlMap::load_text(text, "t"), params), core::InputError) << text;
  EXPECT_THROW(read_output_params(core::YamlMap::load_text("{min_existence: 1.5}", "t"), params),
               core::InputError);
}

TEST(TrackerRegistry, ReadsTheParametersOfTrackers) {
  TrackerParams params;
  read_tracker_params(
      core::YamlMap::load_text("{joint: {birth: {begin_nats: 12}, life: {mean_life_s: 300}}}", "t"), params);
  EXPECT_EQ(params.own.at("joint").at("birth.begin_nats"), 12.0);
  EXPECT_EQ(params.own.at("joint").at("life.mean_life_s"), 300.0);
  for (const char* text : {"{joint: {birth: {begin_nats: -1}}}", "{joint: {births: {}}}",
                           "{gnn: {life: {coast_s: 3}}}", "{joint: {cloud: {trajectories: 64.5}}}"})
    EXPECT_THROW(read_tracker_params(core::YamlMap::load_text(text, "t"), params), core::InputError) << text;
}

TEST(TrackerRegistry, ParametersReachTheirTracker) {
  // Each of these is in its own range and out of a rule between two parameters, which construction knows.
  TrackerParams joint, gnn;
  joint.own["joint"]["cloud.refresh_goal"] = 0.1;  // below refresh_share
  EXPECT_THROW(make_tracker("joint", joint, {}, 1), std::invalid_argument);
  gnn.own["gnn"]["life.confirm_scans"] = 2.0;  // below confirm_hits
  EXPECT_THROW(make_tracker("gnn", gnn, {}, 1), std::invalid_argument);
  EXPECT_NE(make_tracker("kalman", gnn, {}, 1), nullptr);  // the other tracker's do not count
}

TEST(TrackerRegistry, OneKeyTurnsTheMapOffInEveryTrackerThatHasOne) {
  for (const std::string name : {"joint", "csht", "kalman", "gnn"}) {
    TrackerParams params;
    EXPECT_TRUE(make_tracker(name, params, {}, 1)->learns_clutter()) << name;
    read_tracker_params(core::YamlMap::load_text("{" + name + ": {clutter: {map: {enabled: false}}}}", "t"),
                        params);
    EXPECT_FALSE(make_tracker(name, params, {}, 1)->learns_clutter()) << name;
  }
}

TEST(TrackerRegistry, EveryTrackerListsItsParameters) {
  for (const char* name : {"joint", "csht", "kalman", "gnn", "jipda", "gm_phd", "pmbm"})
    EXPECT_FALSE(own_parameters(name).list.all().empty()) << name;
  EXPECT_TRUE(own_parameters("nothing").list.all().empty());
}

TEST(TrackerRegistry, RefusesAnInitiatorWhereBirthsHaveProbabilities) {
  TrackerParams params;
  params.initiator = "vct";
  EXPECT_NE(make_tracker("gnn", params, {}, 1), nullptr);
  for (const char* name : {"jipda", "gm_phd", "pmbm"})
    EXPECT_THROW(make_tracker(name, params, {}, 1), std::invalid_argument) << name;
  params.initiator = "jipda";
  EXPECT_NE(make_tracker("jipda", params, {}, 1), nullptr);
}

TEST(TrackerRegistry, TakesATrackerFromOutside) {
  const auto make = [](const TrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed) {
    return make_tracker("gnn", params, sonar, seed);
  };
  register_tracker("outsider", "sht", make);
  EXPECT_EQ(default_estimator("outsider"), "sht");
  EXPECT_NE(make_tracker("outsider", {}, {}, 1), nullptr);
  EXPECT_THROW(register_tracker("outsider", "", make), std::invalid_argument);
  EXPECT_THROW(register_tracker("joint", "", make), std::invalid_argument);
  EXPECT_THROW(register_tracker("no name", "", make), std::invalid_argument);
  EXPECT_THROW(register_tracker("other", "no_such_estimator", make), std::invalid_argument);
  EXPECT_THROW(register_tracker("other", "", nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
