// The geometry of a folder of pictures, YAML.
#include <filesystem>

#include "tests/fuzz/fuzz_support.hpp"
#include "tools/import/import_pgm.hpp"

namespace {

std::string pictures() {
  std::filesystem::create_directories(lookout::tests::scratch().file("pictures"));
  lookout::tests::write_scratch("pictures/a1.pgm", "P5\n4 3\n255\nabcdefghijkl");
  lookout::tests::write_scratch("pictures/a2.pgm", "P2\n4 3\n99\n1 2 3 4 5 6 7 8 9 10 11 12\n");
  return lookout::tests::scratch().file("pictures");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  static const std::string folder = pictures();
  const std::string geometry = tests::write_scratch("geometry.yaml", tests::as_text(data, size));
  tests::read_or_refuse([&] { tools::import_pgm(folder, geometry, tests::scratch().file("out")); });
  return 0;
}
