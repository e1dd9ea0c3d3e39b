#include "tracking/initiation/initiator_registry.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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

}  // namespace
}  // namespace lookout::tracking
