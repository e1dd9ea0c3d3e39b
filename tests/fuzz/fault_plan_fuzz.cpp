// A plan of faults, YAML.
#include "tests/fuzz/fuzz_support.hpp"
#include "tools/fault/fault_plan.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  const std::string text(tests::as_text(data, size));
  tests::read_or_refuse([&] { tools::read_fault_plan(text, "plan.yaml"); });
  return 0;
}
