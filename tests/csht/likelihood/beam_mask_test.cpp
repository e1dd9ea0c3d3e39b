#include "csht/likelihood/beam_mask.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "csht/likelihood/sensor_likelihood.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

ScanTable table_with_return(double range) {
  ScanTable table;
  fill_scan_table(posed_scan({{core::radians(0.5), range, 1}}), table);
  set_figures({.miss_probability = 0.3, .false_alarm_probability = 0.1}, {}, table);
  return table;
}

TEST(BeamMask, WhoStandsBehindTheOwnerLearnsNothing) {
  const ScanTable table = table_with_return(80.0);
  BeamMask mask;
  mask.clear(table);
  claim_beam(table, 45, 60.0, 1.0, mask);
  EXPECT_NEAR(log_ratio(table, &mask, core::from_polar(80.0, core::radians(0.5))), 0.0, 1e-6);
}

TEST(BeamMask, WhoStandsInFrontTakesTheReturnFromTheOwner) {
  const ScanTable table = table_with_return(80.0);
  BeamMask mask;
  mask.clear(table);
  claim_beam(table, 45, 80.0, 1.0, mask);
  const double owner = log_ratio(table, nullptr, core::from_polar(80.0, core::radians(0.5)));
  // The return fits the owner alone: a nearer target would have hidden it. Floor less the owner's worth.
  EXPECT_NEAR(log_ratio(table, &mask, core::from_polar(50.0, core::radians(0.5))), -8.0 - owner, 1e-4);
}

TEST(BeamMask, ClaimsJoin) {
  const ScanTable table = table_with_return(80.0);
  BeamMask mask;
  mask.clear(table);
  EXPECT_TRUE(mask.empty);
  claim_beam(table, 45, 80.0, 0.5, mask);
  claim_beam(table, 45, 60.0, 0.5, mask);
  claim_beam(table, 90, 60.0, 1.0, mask);  // No such beam: ignored.
  EXPECT_FLOAT_EQ(mask.share[46], 0.75F);  // 1 - 0.5 x 0.5.
  EXPECT_FLOAT_EQ(mask.range[46], 60.0F);
  EXPECT_FALSE(mask.empty);
}

}  // namespace
}  // namespace lookout::csht
