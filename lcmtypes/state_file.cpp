#include "lcmtypes/state_file.hpp"

#include <boost/crc.hpp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/files/text_file.hpp"
#include "lcmtypes/convert.hpp"
#include "lcmtypes/inbox.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr std::string_view kMagic = "lookout state 1\n";
constexpr std::uintmax_t kLargestFile = 64U << 20U;  // [bytes]; the largest that is written has a tenth.

/// Puts numbers and messages one behind the other.
class Writer {
 public:
  void add(std::int64_t number) { text_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  template <class Wire>
  void add_message(const Wire& wire) {
    const int size = wire.getEncodedSize();
    add(size);
    text_.resize(text_.size() + static_cast<std::size_t>(size));
    wire.encode(text_.data() + text_.size() - size, 0, size);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Takes them off again; nothing where the text ends before, or holds something else.
class Reader {
 public:
  explicit Reader(std::string_view rest) : rest_(rest) {}
  std::optional<std::int64_t> number() {
    std::int64_t value = 0;
    if (rest_.size() < sizeof value) return std::nullopt;
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
    return value;
  }
  template <class Wire>
  auto message() -> decltype(to_core(Wire()).value) {
    const auto size = number();
    if (!size || *size < 0 || static_cast<std::uint64_t>(*size) > rest_.size()) return std::nullopt;
    const auto wire = decode<Wire>(rest_.data(), static_cast<std::size_t>(*size));
    rest_.remove_prefix(static_cast<std::size_t>(*size));
    if (!wire) return std::nullopt;
    return to_core(*wire).value;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

std::int64_t checksum(std::string_view body) {
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  return crc.checksum();
}

/// The scans that remain; false where one is not good.
bool read_scans(Reader& reader, core::TrackingMemory& memory) {
  while (!reader.at_end()) {
    auto vehicle = reader.message<vehicle_state_t>();
    auto scan = vehicle ? reader.message<sonar_scan_t>() : std::nullopt;
    if (!scan) return false;
    memory.scans.push_back({*vehicle, *std::move(scan)});
  }
  return true;
}

LoadedState read_body(std::string_view body) {
  Reader reader(body);
  core::TrackingMemory memory;
  const auto next_id = reader.number();
  auto tracks = reader.message<track_list_t>();
  if (!next_id || *next_id < 1 || !tracks || !read_scans(reader, memory))
    return {std::nullopt, "holds what this release does not read"};
  memory.next_id = *next_id;
  memory.utime = tracks->key.utime;
  memory.tracks = std::move(tracks->tracks);
  return {std::move(memory), {}};
}

}  // namespace

std::string state_text(const core::TrackingMemory& memory) {
  Writer body, whole;
  body.add(memory.next_id);
  body.add_message(to_wire(ScanKey{memory.utime, 0, 0}, memory.tracks).message);
  for (const auto& [vehicle, scan] : memory.scans) {
    body.add_message(to_wire(vehicle));
    body.add_message(to_wire(scan));
  }
  whole.add(static_cast<std::int64_t>(body.text().size()));
  whole.add(checksum(body.text()));
  return std::string(kMagic).append(whole.text()).append(body.text());
}

LoadedState read_state(const std::string& text) {
  if (!text.starts_with(kMagic)) return {std::nullopt, "is no state of this version"};
  const std::string_view rest = std::string_view(text).substr(kMagic.size());
  Reader head(rest);
  const auto size = head.number(), sum = head.number();
  if (!size || !sum) return {std::nullopt, "is cut"};
  const std::string_view body = rest.substr(2 * sizeof(std::int64_t));
  if (*size < 0 || body.size() != static_cast<std::uint64_t>(*size)) return {std::nullopt, "is cut"};
  if (checksum(body) != *sum) return {std::nullopt, "is damaged: its checksum is another"};
  return read_body(body);
}

void save_state(const std::string& path, const core::TrackingMemory& memory) {
  core::write_text_file(path, state_text(memory));
}

LoadedState load_state(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  if (!std::filesystem::is_regular_file(path, error)) return {std::nullopt, "is no plain file"};
  if (std::filesystem::file_size(path, error) > kLargestFile)
    return {std::nullopt, "is too large for a state"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return {std::nullopt, "cannot be read"};
  return read_state({std::istreambuf_iterator<char>(file), {}});
}

}  // namespace lookout::lcmtypes
