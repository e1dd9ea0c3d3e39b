// A scene, YAML.
#include "sonar_sim/scene.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  const std::string text(tests::as_text(data, size));
  tests::read_or_refuse([&] { sonar_sim::parse_scene(text, "scene.yaml"); });
  return 0;
}
