// docs/parameters.md is what the program knows of its trackers' parameters. LOOKOUT_WRITE_PARAMETERS=1 writes
// it anew: LOOKOUT_WRITE_PARAMETERS=1 build/tests/integration/integration_tests
// --gtest_filter='ParametersPage.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "core/files/text_file.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tests {
namespace {

constexpr const char* kPage = LOOKOUT_SOURCE_DIR "/docs/parameters.md";
constexpr const char* kHead =
    R"(# Parameters of the trackers

Made of the docstrings beside each struct of parameters; a test compares this page with the program. To write it anew:
`LOOKOUT_WRITE_PARAMETERS=1 build/tests/integration/integration_tests --gtest_filter='ParametersPage.*'`.

A configuration (`--config FILE.yaml`) sets a parameter under its tracker, nested as its path says:

```yaml
tracker:
  name: joint
  coast_s: 10.0                         # how long a track is kept outside the field of view [s], of every tracker
  joint: {birth: {begin_nats: 12.0}, life: {mean_life_s: 300.0}}
```

A key that is not known, a value out of range and parameters of another tracker than the one that runs are errors.
`lookout tune SCENE --parameter joint.birth.begin_nats=8:14` sweeps one: the tracker's name, a point, the path.
`output: {min_existence: ...}` sets the existence from which a track is reported; what else `--config` holds is in
[formats.md](formats.md). The estimator joint shares these parameters of the engine with the tracker joint.

The default of csht's `element_gate.velocity` is half the sensor's `max_speed`; where an initiator begins tracks, those of
kalman and gnn are confirmed at birth unless `life.confirm_hits` and `life.confirm_scans` are given.
)";

/// One line of a table, bars in the text escaped.
std::string row_of(const core::Parameter& parameter) {
  std::string meaning;
  for (const char c : parameter.meaning) meaning.append(c == '|' ? "\\|" : std::string(1, c));
  const bool is_flag = parameter.kind() == "true or false";
  std::string accepted = parameter.kind();
  if (!is_flag)
    accepted.append(" ").append(parameter.accepted.text() == "any number" ? "" : parameter.accepted.text());
  if (accepted.ends_with(' ')) accepted.pop_back();
  std::ostringstream row;
  row << "| `" << parameter.path << "` | " << parameter.present() << " | " << accepted << " | " << meaning
      << " |\n";
  return row.str();
}

std::string page() {
  std::ostringstream text;
  text << kHead;
  for (const auto& tracker : tracking::tracker_names()) {
    const tracking::ListedParameters own = tracking::own_parameters(tracker);
    if (own.list.all().empty()) continue;
    text << "\n## " << tracker << "\n\n| path | default | accepted | meaning |\n| --- | --- | --- | --- |\n";
    for (const auto& parameter : own.list.all()) text << row_of(parameter);
  }
  return text.str();
}

TEST(ParametersPage, IsWhatTheProgramKnows) {
  if (std::getenv("LOOKOUT_WRITE_PARAMETERS") != nullptr) core::write_text_file(kPage, page());
  EXPECT_EQ(core::read_text_file(kPage, "a page"), page())
      << "docs/parameters.md is not up to date: see the top of parameters_page_test.cpp";
}

TEST(ParametersPage, EveryParameterHasADocstring) {
  for (const auto& tracker : tracking::tracker_names()) {
    const tracking::ListedParameters own =
        tracking::own_parameters(tracker);  // holds what the list points into
    for (const auto& parameter : own.list.all()) {
      EXPECT_GT(parameter.meaning.size(), 10U) << tracker << "." << parameter.path;
      const auto now = parameter.number();
      EXPECT_TRUE(!now || parameter.accepted.holds(*now)) << tracker << "." << parameter.path;
    }
  }
}

}  // namespace
}  // namespace lookout::tests
