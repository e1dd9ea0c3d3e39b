// A configuration, YAML, with every part that it may have.
#include "tests/fuzz/fuzz_support.hpp"
#include "tools/cli/configuration.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  tools::Options options;
  options.config = "config.yaml";
  options.config_text = tests::as_text(data, size);
  tests::read_or_refuse([&] { tools::load_configuration(options); });
  return 0;
}
