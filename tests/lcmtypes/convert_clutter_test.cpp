#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "lcmtypes/convert.hpp"
#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

using namespace lookout::tests;

constexpr std::size_t kDatagram = 65'499;  // Largest payload of a UDP datagram that LCM sends whole.

TEST(ConvertClutter, GridThereAndBack) {
  const auto back = to_core(to_wire(example_clutter_grid())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, 2'000'000);
  EXPECT_EQ(back->sensor_id, 7);
  EXPECT_EQ(back->T_earth_sonar.north, 1.5);
  EXPECT_EQ(back->T_earth_sonar.east, -2.5);
  EXPECT_EQ(back->T_earth_sonar.heading, 0.25);
  EXPECT_EQ(back->first_bearing, -0.75);
  EXPECT_EQ(back->bearing_step, 0.5);
  EXPECT_EQ(back->range_step, 10.0);
  EXPECT_EQ(back->num_bearings, 3);
  EXPECT_EQ(back->num_ranges, 2);
  EXPECT_EQ(back->density, (std::vector<std::int8_t>{0, 1, 20, 30, 126, 127}));
}

TEST(ConvertClutter, TheLargestGridFitsADatagramAndALargerIsRefused) {
  auto grid = example_clutter_grid();
  grid.num_bearings = grid.num_ranges = 64;
  grid.density.assign(kMaxClutterCells, 1);
  EXPECT_LT(encoded(to_wire(grid)).size(), kDatagram / 10);
  grid.num_ranges = 65;
  grid.density.assign(64 * 65, 1);
  EXPECT_THROW(to_wire(grid), std::length_error);
  grid.num_ranges = 64;
  EXPECT_THROW(to_wire(grid), std::length_error);  // Sizes that disagree.
}

/// Why the example is refused after `change`.
template <class Change>
std::string_view refusal(const Change& change) {
  clutter_map_t wire = to_wire(example_clutter_grid());
  change(wire);
  return to_core(wire).refusal;
}

TEST(ConvertClutter, RefusesWhatIsNoGrid) {
  using Wire = clutter_map_t;
  const std::string_view disagrees = "clutter map: number disagrees with the cells";
  EXPECT_EQ(refusal([](Wire& wire) { wire.num_bearings = 2; }), disagrees);
  EXPECT_EQ(refusal([](Wire& wire) { wire.density[1].pop_back(); }), disagrees);
  EXPECT_EQ(refusal([](Wire& wire) { wire.density.clear(), wire.num_bearings = 0; }), disagrees);
  EXPECT_EQ(refusal([](Wire& wire) {
              wire.num_bearings = 4097;
              wire.num_ranges = 1;
              wire.density.assign(4097, {1});
            }),
            "clutter map: too many cells");
}

TEST(ConvertClutter, RefusesNumbersThatAreNone) {
  using Wire = clutter_map_t;
  EXPECT_EQ(refusal([](Wire& wire) { wire.utime = std::numeric_limits<std::int64_t>::max(); }),
            "clutter map: time out of range");
  EXPECT_EQ(refusal([](Wire& wire) { wire.sonar_heading = std::numeric_limits<double>::quiet_NaN(); }),
            "clutter map: not finite");
  EXPECT_EQ(refusal([](Wire& wire) { wire.range_step = 0.0; }), "clutter map: a step is not above 0");
  EXPECT_EQ(refusal([](Wire& wire) { wire.density[2][1] = -1; }), "clutter map: a density is below 0");
}

}  // namespace
}  // namespace lookout::lcmtypes
