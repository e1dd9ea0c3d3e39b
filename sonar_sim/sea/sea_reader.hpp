#pragma once

#include <optional>

#include "core/files/yaml_reader.hpp"
#include "sonar_sim/sea/sea_plan.hpp"

/// The `sea` section of a scene; docs/sea.md has its keys.
namespace lookout::sonar_sim {

struct SonarPlan;

/// The scene's own `sea`, which holds for every sonar that does not say otherwise.
class SeaSection {
 public:
  /// @throws core::InputError naming file, line, column and key.
  explicit SeaSection(std::optional<core::YamlMap> map);

  /// What was read.
  const SeaPlan& plan() const { return plan_; }
  /// Of the `sea:` section; absent without one.
  const std::optional<core::YamlMap>& map() const { return map_; }

 private:
  std::optional<core::YamlMap> map_;
  SeaPlan plan_;
};

/// The sea of one sonar: the scene's, with each key that the sonar's own `sea` gives in place of the scene's.
/// @throws core::InputError as above, and where the sea contradicts the sonar.
SeaPlan read_sea(const SeaSection& scene, const std::optional<core::YamlMap>& own, const SonarPlan& sonar);

}  // namespace lookout::sonar_sim
