// A grey image, PGM of every kind: what is read has all its pixels.
#include "core/files/grey_image.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  const std::string path = tests::write_scratch("image.pgm", tests::as_text(data, size));
  tests::read_or_refuse([&] {
    const core::GreyImage image = core::read_pgm(path);
    tests::require(image.columns > 0 && image.rows > 0 &&
                   image.pixels.size() ==
                       static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows));
  });
  return 0;
}
