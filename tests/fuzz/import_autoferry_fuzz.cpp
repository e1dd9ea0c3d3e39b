// A pair of files of the Autoferry data set, JSON: detections, a line of three percent signs, ground truth.
#include <algorithm>

#include "tests/fuzz/fuzz_support.hpp"
#include "tools/import/import_autoferry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  constexpr std::string_view kBetween = "%%%\n";
  const std::string_view both = tests::as_text(data, size);
  const std::size_t end = std::min(both.find(kBetween), both.size());
  const std::size_t begin = std::min(end + kBetween.size(), both.size());
  const std::string detections = tests::write_scratch("d.json", both.substr(0, end));
  const std::string truth = tests::write_scratch("g.json", both.substr(begin));
  tests::read_or_refuse([&] { tools::import_autoferry(detections, truth, tests::scratch().file("out")); });
  return 0;
}
