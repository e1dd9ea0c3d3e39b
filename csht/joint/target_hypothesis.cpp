#include "csht/joint/target_hypothesis.hpp"

namespace lookout::csht {

void advance(double seconds, TargetHypothesis& hypothesis) {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion(0, 2) = motion(1, 3) = seconds;
  hypothesis.mean = motion * hypothesis.mean;
  hypothesis.covariance = motion * hypothesis.covariance * motion.transpose();
  for (auto& sample : hypothesis.samples) sample = motion * sample;
}

}  // namespace lookout::csht
