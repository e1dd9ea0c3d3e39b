#include "tools/import/oculus_packets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/beam_bearings.hpp"
#include "core/sonar_limits.hpp"

static_assert(std::endian::native == std::endian::little, "the packets are read as they lie in memory");

namespace lookout::tools {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint16_t kMark = 0x4F53;
constexpr std::uint16_t kSimplePing = 0x23;
constexpr std::size_t kHeader = 16, kKindAt = 6, kVersionAt = 8, kPayloadAt = 10, kFlagsAt = 20;
constexpr std::uint8_t kRowGains = 1U << 2U;
constexpr std::size_t kGainBytes = 4;
constexpr double kNanosecond = 1e-9;
constexpr double kNanosecondWrap = 4'294'967'296.0 * kNanosecond;  // 2^32 of them
constexpr double kBearingUnit = 0.01;                              // degrees

/// Where the fields of a simple ping lie, from the packet's start.
struct Layout {
  std::size_t number, frequency, sound_speed, start, value_size, resolution, counts, image, bearings;
  bool start_in_seconds;  ///< A double of seconds, else 32 bits of nanoseconds.
};
constexpr Layout kFirst{53, 61, 85, 93, 97, 98, 106, 110, 122, false};
constexpr Layout kSecond{89, 97, 145, 153, 161, 162, 170, 190, 202, true};

template <class Number>
Number read(Bytes packet, std::size_t at) {
  Number value{};
  std::memcpy(&value, packet.data() + at, sizeof value);
  return value;
}

/// Where the image of a packet lies and what shape it has.
struct ImageBlock {
  std::size_t beams, ranges, value_size, row_gain, offset, size, packet_size;
  std::size_t row() const { return row_gain + beams * value_size; }
};

ImageBlock block_of(Bytes packet, const Layout& layout) {
  ImageBlock block{};
  block.ranges = read<std::uint16_t>(packet, layout.counts);
  block.beams = read<std::uint16_t>(packet, layout.counts + 2);
  block.value_size = std::size_t{read<std::uint8_t>(packet, layout.value_size)} + 1;
  block.row_gain = (read<std::uint8_t>(packet, kFlagsAt) & kRowGains) != 0 ? kGainBytes : 0;
  block.offset = read<std::uint32_t>(packet, layout.image);
  block.size = read<std::uint32_t>(packet, layout.image + 4);
  block.packet_size = read<std::uint32_t>(packet, layout.image + 8);
  return block;
}

/// What is wrong with the shape; empty: nothing.
std::string fault(const ImageBlock& block, const Layout& layout, std::size_t packet_size) {
  const std::string shape =
      std::to_string(block.beams) + " beams x " + std::to_string(block.ranges) + " ranges";
  if (block.beams == 0 || block.ranges == 0 || block.beams * block.ranges > core::SonarLimits::kMaxPixels ||
      block.ranges > core::SonarLimits::kMaxBins || block.beams > core::SonarLimits::kMaxBeams)
    return "states " + shape;
  if (block.value_size == 3 || block.value_size > 4)
    return "states values of " + std::to_string(block.value_size) + " bytes";
  if (block.size != block.ranges * block.row())
    return "states " + std::to_string(block.size) + " bytes of image for " + shape;
  if (block.packet_size != packet_size) return "states two sizes";
  if (layout.bearings + 2 * block.beams > packet_size || block.offset + block.size > packet_size)
    return "its image or bearings reach beyond it";
  return {};
}

double value_at(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes, size);
  return value;
}

/// Range by range on the wire, beam by beam in an image.
std::vector<double> intensities(Bytes packet, const ImageBlock& block) {
  std::vector<double> values(block.beams * block.ranges);
  for (std::size_t range = 0; range < block.ranges; ++range) {
    const std::uint8_t* row = packet.data() + block.offset + range * block.row() + block.row_gain;
    for (std::size_t beam = 0; beam < block.beams; ++beam)
      values[beam * block.ranges + range] = value_at(row + beam * block.value_size, block.value_size);
  }
  return values;
}

core::SonarImage image_of(Bytes packet, const Layout& layout, const ImageBlock& block) {
  core::SonarImage image;
  for (std::size_t beam = 0; beam < block.beams; ++beam)
    image.bearings.push_back(
        core::radians(kBearingUnit * read<std::int16_t>(packet, layout.bearings + 2 * beam)));
  image.range_step = read<double>(packet, layout.resolution);
  image.first_range = 0.5 * image.range_step;
  image.intensity_scale = 1.0;
  image.num_bins = static_cast<int>(block.ranges);
  image.intensity = intensities(packet, block);
  core::count_from_port(image);
  return image;
}

/// A ping, or what is wrong with it.
struct Parsed {
  std::optional<OculusPing> ping;
  std::string wrong;
};

Parsed parse(Bytes packet) {
  const Layout& layout = read<std::uint16_t>(packet, kVersionAt) == 2 ? kSecond : kFirst;
  if (packet.size() < layout.bearings) return {{}, "is shorter than its header"};
  OculusPing ping;
  ping.number = read<std::uint32_t>(packet, layout.number);
  ping.frequency = read<double>(packet, layout.frequency);
  ping.sound_speed = read<double>(packet, layout.sound_speed);
  ping.start = layout.start_in_seconds ? read<double>(packet, layout.start)
                                       : kNanosecond * read<std::uint32_t>(packet, layout.start);
  ping.wrap = layout.start_in_seconds ? 0.0 : kNanosecondWrap;
  const ImageBlock block = block_of(packet, layout);
  const std::string ping_name = "ping " + std::to_string(ping.number) + " ";
  if (const auto wrong = fault(block, layout, packet.size()); !wrong.empty()) return {{}, ping_name + wrong};
  ping.has_row_gains = block.row_gain > 0;
  ping.image = image_of(packet, layout, block);
  if (!core::is_beam_table(ping.image.bearings))
    return {{}, ping_name + "has bearings that neither rise nor fall"};
  if (!(ping.image.range_step > 0.0 && ping.image.range_step < core::SonarLimits::kMaxRange) ||
      !std::isfinite(ping.start))
    return {{}, ping_name + "states no range resolution or time"};
  return {std::move(ping), {}};
}

}  // namespace

OculusPackets::OculusPackets(std::span<const std::uint8_t> bytes, std::string name)
    : bytes_(bytes), name_(std::move(name)) {}

std::optional<OculusPing> OculusPackets::next() {
  while (at_ < bytes_.size()) {
    auto ping = take_packet();
    if (!ping) continue;
    in_damage_ = false;
    return ping;
  }
  return std::nullopt;
}

/// Steps over one packet, or over damage. @return its ping, where it is a whole one.
std::optional<OculusPing> OculusPackets::take_packet() {
  const std::size_t begin = at_, left = bytes_.size() - at_;
  if (left < kHeader || read<std::uint16_t>(bytes_, at_) != kMark) {
    resynchronise();
    note(begin, std::to_string(at_ - begin) + " bytes that are no packet");
    return std::nullopt;
  }
  const std::size_t size = kHeader + read<std::uint32_t>(bytes_, at_ + kPayloadAt);
  if (size > left) {
    resynchronise();
    note(begin, "a packet of " + std::to_string(size) + " bytes is cut off or damaged");
    return std::nullopt;
  }
  const Bytes packet = bytes_.subspan(at_, size);
  if (read<std::uint16_t>(packet, kKindAt) != kSimplePing) {
    in_damage_ = false;
    at_ += size;
    ++other_packets_;
    return std::nullopt;
  }
  Parsed parsed = parse(packet);
  if (parsed.ping) return at_ += size, std::move(parsed.ping);
  resynchronise();
  note(begin, parsed.wrong);
  return std::nullopt;
}

/// On to the next mark behind this place.
void OculusPackets::resynchronise() {
  constexpr std::uint8_t kMarkBytes[] = {kMark & 0xffU, kMark >> 8U};
  const auto from = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(at_ + 1, bytes_.size()));
  const auto found = std::search(from, bytes_.end(), std::begin(kMarkBytes), std::end(kMarkBytes));
  at_ = static_cast<std::size_t>(found - bytes_.begin());
}

/// Marks that an image holds by chance are no packets: within damage, what does not call itself a ping is
/// passed by.
void OculusPackets::note(std::size_t at, const std::string& what) {
  const bool says_ping = bytes_.size() - at >= kHeader && read<std::uint16_t>(bytes_, at) == kMark &&
                         read<std::uint16_t>(bytes_, at + kKindAt) == kSimplePing;
  if (std::exchange(in_damage_, true) && !says_ping) return;
  damages_.push_back(name_ + ": byte " + std::to_string(at) + ": " + what);
}

}  // namespace lookout::tools
