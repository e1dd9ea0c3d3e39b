#include "tools/cli/configuration.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

std::string error_of(const Options& options) {
  try {
    load_configuration(options);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

Options with_config(const std::string& path) {
  Options options;
  options.config = path;
  return options;
}

TEST(Configuration, DefaultsToTheJointTrackerAndEstimator) {
  const Configuration configuration = load_configuration({});
  EXPECT_EQ(configuration.tracker.name, "joint");
  EXPECT_EQ(configuration.estimator.name, "joint");
  EXPECT_EQ(configuration.lag, 0);
  EXPECT_FALSE(tracks_images(configuration));
}

TEST(Configuration, TheFaithfulTrackerBringsTheFaithfulEstimator) {
  Options options;
  options.tracker = "csht";
  EXPECT_EQ(load_configuration(options).estimator.name, "csht");
  options.estimator = "sht";  // unless one is asked for
  EXPECT_EQ(load_configuration(options).estimator.name, "sht");
}

TEST(Configuration, FlagsWinOverTheFile) {
  const tests::TemporaryDirectory folder;
  Options options = with_config(folder.write(
      "c.yaml", "sensor: {range_sigma: 2.0}\nestimator: {name: ransac}\ntracker: {name: gnn}\n"));
  Configuration configuration = load_configuration(options);
  EXPECT_EQ(configuration.sensor.range_sigma, 2.0);
  EXPECT_EQ(configuration.estimator.name, "ransac");
  EXPECT_EQ(configuration.tracker.name, "gnn");
  options.tracker = "kalman";
  EXPECT_EQ(load_configuration(options).tracker.name, "kalman");
  options.estimator = "h_pmht";
  configuration = load_configuration(options);
  EXPECT_EQ(configuration.tracker.name, "h_pmht");  // It stands in place of any tracker.
  EXPECT_TRUE(tracks_images(configuration));
}

TEST(Configuration, MayBeGivenAsText) {
  Options options = with_config("config");
  options.config_text = R"({"tracker": {"name": "gnn"}, "sensor": {"range_sigma": 2.0}})";
  EXPECT_EQ(load_configuration(options).tracker.name, "gnn");
  EXPECT_EQ(load_configuration(options).sensor.range_sigma, 2.0);
  options.config_text = R"({"trackers": {}})";
  EXPECT_TRUE(error_of(options).starts_with("config:1:")) << error_of(options);
}

TEST(Configuration, TheFileStandsOverWhatIsKnownOfTheSensor) {
  const tests::TemporaryDirectory folder;
  core::SonarParams known;
  known.range_sigma = 0.5;
  known.miss_probability = 0.25;
  const auto options = with_config(folder.write("c.yaml", "sensor: {miss_probability: 0.125}\n"));
  EXPECT_EQ(load_configuration(options, known).sensor.range_sigma, 0.5);
  EXPECT_EQ(load_configuration(options, known).sensor.miss_probability, 0.125);
}

/// What is said of choices that would do nothing; empty for none.
std::string idle(Options options, const std::string& yaml = "") {
  const tests::TemporaryDirectory folder;
  if (!yaml.empty()) options.config = folder.write("c.yaml", yaml);
  try {
    refuse_idle_choices(options, load_configuration(options));
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Configuration, ChoicesWithoutEffectAreRefused) {
  Options joint, kalman, images;
  joint.estimator = "csht";
  kalman.tracker = "kalman";
  images.estimator = "h_pmht";
  EXPECT_EQ(idle(joint), "");  // The tracker begins what the estimator finds.
  EXPECT_EQ(idle(kalman), "");
  EXPECT_NE(idle(kalman, "estimator: {name: csht}\n")
                .find("estimator: name: `csht` has no effect on tracker kalman"),
            std::string::npos);
  EXPECT_NE(idle(kalman, "output: {min_existence: 0.5}\n").find("min_existence: has no effect"),
            std::string::npos);
  EXPECT_NE(idle({}, "estimator: {window_scans: 10}\n").find("window_scans: has no effect"),
            std::string::npos);
  EXPECT_EQ(idle({}, "estimator: {name: joint, window_scans: 20}\ntracker: {name: joint}\n"), "");
  EXPECT_EQ(idle(images), "");
  images.tracker = "gnn";
  EXPECT_EQ(idle(images).find("--tracker: has no effect"), 0u);
}

TEST(Configuration, AClutterMapIsPublishedByTrackersThatLearnOne) {
  Options options;
  options.clutter_every = 5.0;
  for (const char* learning : {"joint", "csht", "kalman", "gnn"}) {
    options.tracker = learning;
    EXPECT_EQ(idle(options), "") << learning;
  }
  options.tracker = "jipda";
  EXPECT_NE(idle(options).find("--publish-clutter: has no effect on tracker jipda"), std::string::npos);
  options.tracker.clear();
  options.estimator = "h_pmht";
  EXPECT_EQ(idle(options).find("--publish-clutter: has no effect"), 0u);
  options.estimator.clear();
  options.clutter_every = 0.0;
  EXPECT_NE(idle(options).find("got 0, expected seconds above 0"), std::string::npos);
}

TEST(Configuration, EveryTrackerOfTheLibraryExplainsItself) {
  Options options;
  options.explain = true;
  for (const auto& tracker : tracking::tracker_names()) {
    options.tracker = tracker;
    EXPECT_EQ(idle(options), "") << tracker;
  }
}

TEST(Configuration, LagIsInMicrosecondsAndBounded) {
  Options options;
  options.lag = 2.5;
  EXPECT_EQ(load_configuration(options).lag, 2'500'000);
  for (const double wrong : {-1.0, 61.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.lag = wrong;
    EXPECT_NE(error_of(options).find("--lag: got"), std::string::npos) << wrong;
  }
}

TEST(Configuration, MistakesNameThePlaceAndWhatIsAccepted) {
  const tests::TemporaryDirectory folder;
  EXPECT_NE(error_of(with_config(folder.write("a.yaml", "tbd: {trunction: zero}\n")))
                .find("a.yaml:1:7: unknown key `trunction`"),
            std::string::npos);
  Options options;
  options.tracker = "imm";
  const std::string error = error_of(options);
  EXPECT_NE(error.find("--tracker: got `imm`, expected one of:"), std::string::npos) << error;
  EXPECT_NE(error.find("joint"), std::string::npos) << error;
}

TEST(Configuration, ATrackersOwnBirthMethodServesNoOther) {
  const tests::TemporaryDirectory folder;
  const auto file = folder.write("c.yaml", "tracker: {name: csht, initiator: joint}\n");
  const std::string place =
      "c.yaml:1:34: initiator: `joint` is the birth method of the tracker `joint` alone";
  EXPECT_NE(error_of(with_config(file)).find(place), std::string::npos) << error_of(with_config(file));
  // The flag wins over the file's tracker, for better and worse.
  Options options = with_config(file);
  options.tracker = "joint";
  EXPECT_EQ(load_configuration(options).tracker.initiator, "joint");
  options = with_config(folder.write("d.yaml", "tracker: {initiator: joint}\n"));
  options.tracker = "gnn";
  EXPECT_NE(error_of(options).find("d.yaml:1:22: initiator: `joint`"), std::string::npos)
      << error_of(options);
}

TEST(Configuration, AnInitiatorsKeysAreThoseOfTheOneThatRuns) {
  const tests::TemporaryDirectory folder;
  const std::string births = "tracker: {name: gnn, initiator: modified_logic}\ninitiator: {rho_step: 2}\n";
  const auto file = folder.write("births.yaml", births);
  EXPECT_NE(error_of(with_config(file)).find("births.yaml:2:13: unknown key `rho_step`"), std::string::npos)
      << error_of(with_config(file));
  EXPECT_EQ(load_configuration(with_config(file), {}, "ht").initiator.rho_step, 2.0);  // on points
}

TEST(Configuration, ParametersOfATrackerThatDoesNotRunAreRefused) {
  const tests::TemporaryDirectory folder;
  Options options = with_config(folder.write("c.yaml", "tracker: {joint: {birth: {seeds: 12}}}\n"));
  EXPECT_EQ(load_configuration(options).tracker.own.at("joint").at("birth.seeds"), 12.0);
  EXPECT_NO_THROW(refuse_idle_choices(options, load_configuration(options)));
  options.tracker = "gnn";
  EXPECT_THROW(refuse_idle_choices(options, load_configuration(options)), core::InputError);
}

TEST(Configuration, SettingsStandOverTheFile) {
  const tests::TemporaryDirectory folder;
  Options options =
      with_config(folder.write("c.yaml", "tracker: {coast_s: 3, joint: {birth: {seeds: 12}}}\n"));
  options.settings = {{"coast_s", 4.0}, {"joint.birth.seeds", 13.0}};
  const Configuration configuration = load_configuration(options);
  EXPECT_EQ(configuration.tracker.coast_s, 4.0);
  EXPECT_EQ(configuration.tracker.own.at("joint").at("birth.seeds"), 13.0);
  options.settings = {{"gnn.gate_probability", 0.9}};
  EXPECT_NE(error_of(options).find("begins with joint."), std::string::npos);
  options.settings = {{"joint.birth.seeds", 0.0}};
  EXPECT_NE(error_of(options).find("expected a number >= 1"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
