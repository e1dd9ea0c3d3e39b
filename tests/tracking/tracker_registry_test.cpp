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

}  // namespace
}  // namespace lookout::tracking
