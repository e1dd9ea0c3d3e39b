#include "tools/experiments/track_before_detect/image_sea.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tools/experiments/track_before_detect/image_sea_run.hpp"
#include "tools/experiments/track_before_detect/image_sea_scene.hpp"

namespace lookout::tools {
namespace {

TEST(ImageSea, CrossesMethodsConditionsLevelsAndBins) {
  const auto cells = make_image_sea()->cells();
  // 5 methods, 2 lengths of a bin, 9 conditions at 2 levels and the empty one at 1.
  EXPECT_EQ(cells.size(), 5u * 2u * (9u * 2u + 1u));
  std::set<std::string> conditions;
  for (const Cell& cell : cells) conditions.insert(cell.parameters.text("condition"));
  EXPECT_EQ(conditions.size(), image_sea_conditions().size());
}

TEST(ImageSea, ErrorsArePooledAsSquares) {
  EXPECT_EQ(make_image_sea()->pooling("rmse"), Pooling::root_mean_square);
  EXPECT_EQ(make_image_sea()->pooling("ospa"), Pooling::mean);
}

}  // namespace
}  // namespace lookout::tools
