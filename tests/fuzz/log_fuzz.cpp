// An LCM log read to its end: each byte is a message's or counted as lost.
#include "lcmtypes/log_reader.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout;
  constexpr std::int64_t kHeader = 28;  // Of an event in an LCM log [bytes].
  const std::string path = tests::write_scratch("log", tests::as_text(data, size));
  tests::read_or_refuse([&] {
    lcmtypes::LogReader reader(path);
    std::int64_t read = 0;
    while (const auto message = reader.next())
      read += kHeader + static_cast<std::int64_t>(message->channel.size() + message->bytes.size());
    tests::require(read + reader.bytes_lost() == reader.size());
  });
  return 0;
}
