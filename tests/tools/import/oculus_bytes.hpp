#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/// Packets as an Oculus sonar sends them, made by the layout of docs/import.md.
namespace lookout::tests {

/// What a ping is to say.
struct OculusSpec {
  int version = 1;
  std::uint32_t number = 1000;
  double start = 0.5;  ///< [s]
  int value_size = 1;  ///< [bytes]
  bool row_gains = false;
  std::vector<std::int16_t> bearings{-1500, -200, 0, 2000};  ///< [0.01 deg]
  int ranges = 3;
  double resolution = 0.25;  ///< [m]
};

/// The value of a beam and range: different for each.
inline std::uint32_t oculus_value(int beam, int range) {
  return static_cast<std::uint32_t>(10 * range + beam + 1);
}

template <class Number>
void put(std::string& bytes, std::size_t at, Number value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// The packet of a ping.
inline std::string oculus_packet(const OculusSpec& spec) {
  const bool second = spec.version == 2;
  const std::size_t bearings_at = second ? 202 : 122, counts_at = second ? 170 : 106,
                    image_at = second ? 190 : 110;
  const std::size_t beams = spec.bearings.size(), ranges = static_cast<std::size_t>(spec.ranges);
  const std::size_t row = beams * static_cast<std::size_t>(spec.value_size) + (spec.row_gains ? 4 : 0);
  const std::size_t offset = bearings_at + 2 * beams + 6, size = offset + ranges * row;
  std::string bytes(size, '\0');
  put<std::uint16_t>(bytes, 0, 0x4F53);
  put<std::uint16_t>(bytes, 6, 0x23);
  put<std::uint16_t>(bytes, 8, static_cast<std::uint16_t>(spec.version));
  put<std::uint32_t>(bytes, 10, static_cast<std::uint32_t>(size - 16));
  put<std::uint8_t>(bytes, 20, spec.row_gains ? 0x04 : 0x00);
  put<std::uint32_t>(bytes, second ? 89 : 53, spec.number);
  put<double>(bytes, second ? 97 : 61, 2.1e6);
  put<double>(bytes, second ? 145 : 85, 1500.0);
  if (second)
    put<double>(bytes, 153, spec.start);
  else
    put<std::uint32_t>(bytes, 93, static_cast<std::uint32_t>(spec.start * 1e9));
  put<std::uint8_t>(bytes, second ? 161 : 97, static_cast<std::uint8_t>(spec.value_size - 1));
  put<double>(bytes, second ? 162 : 98, spec.resolution);
  put<std::uint16_t>(bytes, counts_at, static_cast<std::uint16_t>(ranges));
  put<std::uint16_t>(bytes, counts_at + 2, static_cast<std::uint16_t>(beams));
  put<std::uint32_t>(bytes, image_at, static_cast<std::uint32_t>(offset));
  put<std::uint32_t>(bytes, image_at + 4, static_cast<std::uint32_t>(ranges * row));
  put<std::uint32_t>(bytes, image_at + 8, static_cast<std::uint32_t>(size));
  for (std::size_t beam = 0; beam < beams; ++beam) put(bytes, bearings_at + 2 * beam, spec.bearings[beam]);
  for (std::size_t range = 0; range < ranges; ++range)
    for (std::size_t beam = 0; beam < beams; ++beam) {
      const std::uint32_t value = oculus_value(static_cast<int>(beam), static_cast<int>(range));
      std::memcpy(bytes.data() + offset + range * row +
                      (row - beams * static_cast<std::size_t>(spec.value_size)) +
                      beam * static_cast<std::size_t>(spec.value_size),
                  &value, static_cast<std::size_t>(spec.value_size));
    }
  return bytes;
}

}  // namespace lookout::tests
