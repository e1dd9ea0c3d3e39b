#include "csht/single_line.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

SingleLine extractor() {
  return {{}, HoughSpace({0.4, 1.5, 5.0, 300.0}, {}, 3.0, 3.0)};
}

// Exact line samples: the mean of the cells about the peak is the line to a quarter of a grid step (the peak
// is symmetric, the cells' phases about it are not).
TEST(SingleLine, FindsTheLineOfExactSamples) {
  std::vector<LineSample> samples;
  for (int k = 0; k < 20; ++k) samples.push_back({k, 0.5 * k, 10.0 + 1.3 * 0.5 * k, 3.0});
  auto single_line = extractor();
  const auto line = single_line.extract(samples, 4.75, 0.0);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->velocity, 1.3, 0.25 * 0.4);
  EXPECT_NEAR(line->intercept, 10.0 + 1.3 * 4.75, 0.25 * 1.5);  // at 4.75 s
}

TEST(SingleLine, IsNotBentByAFewSamplesElsewhere) {
  std::vector<LineSample> samples;
  for (int k = 0; k < 20; ++k) samples.push_back({k, 0.5 * k, 10.0, 3.0});
  for (int k = 0; k < 5; ++k) samples.push_back({20 + k, 0.5 * k, 80.0, 3.0});
  auto single_line = extractor();
  const auto line = single_line.extract(samples, 4.75, 0.0);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->intercept, 10.0, 0.25 * 1.5);
}

TEST(SingleLine, WithoutSamplesThereIsNone) {
  auto single_line = extractor();
  EXPECT_FALSE(single_line.extract({}, 0.0, 0.0));
}

}  // namespace
}  // namespace lookout::csht
