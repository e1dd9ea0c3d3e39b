#include "tracking/initiation/initiator_registry.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/reading.hpp"

namespace lookout::tracking {
namespace {

TEST(InitiatorRegistry, NamesTheMethodsOfTheContract) {
  const auto names = initiator_names();
  EXPECT_EQ(std::vector<std::string>(names.begin(), names.end()),
            (std::vector<std::string>{"ht", "mht_ti", "iht_ti", "nht_ti", "ag_fht", "modified_logic",
                                      "modified_ht", "sequence_ht", "fpht", "nht_plus", "vct"}));
}

TEST(InitiatorRegistry, HandsTheConfigurationOn) {
  InitiatorConfig config;
  config.window_scans = 9;
  EXPECT_EQ(make_initiator("vct", config)->window_scans(), 9);
}

TEST(InitiatorRegistry, AnUnknownNameIsRefusedWithTheAccepted) {
  try {
    make_initiator("guess", {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("modified_logic"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("guess"), std::string::npos) << error.what();
  }
}

/// The message with which `initiator:` for one initiator is refused.
std::string refusal(const std::string& name, InitiatorUse use, const std::string& text) {
  InitiatorConfig config;
  return testing::error_of(
      [&] { read_initiator_config(core::YamlMap::load_text(text, "test.yaml"), name, use, config); });
}

TEST(InitiatorRegistry, RefusesAKeyThatTheMethodDoesNotUseAndNamesThoseThatItDoes) {
  const std::string message = refusal("modified_logic", InitiatorUse::points, "{rho_step: 2}");
  EXPECT_NE(message.find("test.yaml:1:2: unknown key `rho_step`"), std::string::npos) << message;
  EXPECT_NE(message.find("max_turn_deg"), std::string::npos) << message;
  EXPECT_EQ(refusal("ht", InitiatorUse::points, "{rho_step: 2, position_sigma: 3}"), "no error");
  EXPECT_NE(refusal("ht", InitiatorUse::births, "{position_sigma: 3}"), "no error");
  EXPECT_EQ(refusal("ht", InitiatorUse::births, "{max_false_tracks: 1}"), "no error");
}

TEST(InitiatorRegistry, RefusesOfBirthsWhatHasNoEffectThere) {
  // VCT works on the sonar's scans as they are: there is no margin around a plot.
  EXPECT_NE(refusal("vct", InitiatorUse::births, "{gate_margin: 3}"), "no error");
  EXPECT_EQ(refusal("ag_fht", InitiatorUse::births, "{gate_margin: 3}"), "no error");
  // `modified_ht` looks at three scans, always.
  EXPECT_NE(refusal("modified_ht", InitiatorUse::births, "{window_scans: 5}"), "no error");
  EXPECT_EQ(refusal("modified_logic", InitiatorUse::births, "{window_scans: 5}"), "no error");
}

TEST(InitiatorRegistry, WithoutAMethodAcceptsTheKeysOfAllAndNoOther) {
  EXPECT_EQ(refusal("", InitiatorUse::births, "{rho_step: 2, gate_probability: 0.9}"), "no error");
  EXPECT_NE(refusal("", InitiatorUse::births, "{rho_stp: 2}"), "no error");
}

class Idle final : public Initiator {
 public:
  const StartedTracks& start(const PlotWindow&) override { return started_; }
  int window_scans() const override { return 5; }

 private:
  StartedTracks started_;
};

std::unique_ptr<Initiator> make_idle(const InitiatorConfig&) {
  return std::make_unique<Idle>();
}

TEST(RegisterInitiator, RefusesATakenNameABadOneAndNothing) {
  const std::size_t before = initiator_names().size();
  EXPECT_THROW(register_initiator("vct", &make_idle), std::invalid_argument);
  EXPECT_THROW(register_initiator("joint", &make_idle), std::invalid_argument);  // a tracker's own births
  EXPECT_THROW(register_initiator("a-b", &make_idle), std::invalid_argument);
  EXPECT_THROW(register_initiator("none", nullptr), std::invalid_argument);
  EXPECT_EQ(initiator_names().size(), before);
}

// The last test here: what is registered stays.
TEST(RegisterInitiator, IsKnownByNameAndByItsKeysAlone) {
  register_initiator("idle", &make_idle, {{"shyness", core::kPositive}, {"min_plots"}});
  EXPECT_EQ(initiator_names().back(), "idle");
  EXPECT_EQ(make_initiator("idle", {})->window_scans(), 5);
  EXPECT_EQ(refusal("idle", InitiatorUse::points, "{shyness: 1, min_plots: 3}"), "no error");
  EXPECT_NE(refusal("idle", InitiatorUse::points, "{shyness: -1}"), "no error");
  EXPECT_NE(refusal("idle", InitiatorUse::points, "{rho_step: 2}"), "no error");
  EXPECT_NE(refusal("ht", InitiatorUse::points, "{shyness: 1}"), "no error");
}

}  // namespace
}  // namespace lookout::tracking
