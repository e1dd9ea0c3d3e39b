#include "csht/likelihood/clutter/clutter_map_params.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::csht {
namespace {

template <class Value>
void expect_refused(Value ClutterMapParams::*member, Value value) {
  ClutterMapParams params;
  params.*member = value;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

TEST(ClutterMapParams, RefusesWhatIsOutOfRange) {
  expect_refused(&ClutterMapParams::memory_looks, 1);
  expect_refused(&ClutterMapParams::leave_out_time, 0.0);
  expect_refused(&ClutterMapParams::least_share, 0.5);
  expect_refused(&ClutterMapParams::most_dense, 1.0);
  expect_refused(&ClutterMapParams::sonar_learning, DenseReturnsParams{.memory_scans = 1.0});
  expect_refused(&ClutterMapParams::earth_learning, DenseReturnsParams{.prior_returns = 0.0});
  expect_refused(&ClutterMapParams::most_returns, 1);
}

}  // namespace
}  // namespace lookout::csht
