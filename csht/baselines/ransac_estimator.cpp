#include "csht/baselines/ransac_estimator.hpp"

#include <mrpt/math/ransac.h>
#include <mrpt/random/RandomGenerators.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"
#include "csht/scan_to_detections.hpp"

namespace lookout::csht {
namespace {

using Points = mrpt::math::CMatrixDynamic<double>;  // 2 x N: north, east.
using Line = mrpt::math::CMatrixDynamic<double>;    // 1 x 3: a n + b e + c = 0 with a^2 + b^2 = 1.

constexpr double kTooNear = 1e-6;  // Two points through which no line is laid [m].
constexpr double kLeastDeterminant =
    1e-9;  // Of a regression over time; below it all detections have one time.
constexpr std::uint64_t kSeedFactor = 2654435761U;  // 2^32 over the golden ratio: spreads neighbouring seeds.

bool too_near(const Points& points, const std::vector<std::size_t>& pair) {
  const auto a = static_cast<int>(pair[0]), b = static_cast<int>(pair[1]);
  return std::hypot(points(0, a) - points(0, b), points(1, a) - points(1, b)) < kTooNear;
}

void line_through(const Points& points, const std::vector<std::size_t>& pair, std::vector<Line>& lines) {
  const auto a = static_cast<int>(pair[0]), b = static_cast<int>(pair[1]);
  const double dn = points(0, b) - points(0, a), de = points(1, b) - points(1, a);
  const double length = std::hypot(dn, de);
  Line line(1, 3);
  line(0, 0) = -de / length;
  line(0, 1) = dn / length;
  line(0, 2) = -line(0, 0) * points(0, a) - line(0, 1) * points(1, a);
  lines.assign(1, line);
}

void near_line(const Points& points, const std::vector<Line>& lines, double threshold, unsigned int& best,
               std::vector<std::size_t>& inliers) {
  best = 0;
  inliers.clear();
  const Line& line = lines[0];
  for (int i = 0; i < points.cols(); ++i)
    if (std::abs(line(0, 0) * points(0, i) + line(0, 1) * points(1, i) + line(0, 2)) < threshold)
      inliers.push_back(static_cast<std::size_t>(i));
}

// MRPT's RANSAC draws from a generator that the whole process shares: one caller at a time, seeded anew, so
// that the answer depends on nothing but the seed.
std::vector<std::size_t> ransac_line(const Points& points, double threshold, int max_draws,
                                     std::uint32_t seed) {
  static std::mutex shared_generator;
  const std::lock_guard lock(shared_generator);
  mrpt::random::getRandomGenerator().randomize(seed);
  mrpt::math::RANSAC_Template<double> ransac;
  ransac.setMinLoggingLevel(mrpt::system::LVL_ERROR);  // Else it writes to standard output.
  std::vector<std::size_t> inliers;
  Line line;
  constexpr double kSureOfAPair = 0.999;  // MRPT's own default.
  ransac.execute(points, line_through, near_line, too_near, threshold, 2, inliers, line, kSureOfAPair,
                 static_cast<std::size_t>(max_draws));
  return inliers;
}

}  // namespace

RansacEstimator::RansacEstimator(const RansacParams& params, const core::SonarParams& sonar,
                                 std::uint64_t seed)
    : params_(params), sonar_(sonar), seed_(seed) {
  core::require(params.window_scans >= 3, "window_scans must be >= 3", params.window_scans);
  core::require(params.first_estimate_scans >= 1 && params.first_estimate_scans <= params.window_scans,
                "first_estimate_scans must be 1 to window_scans", params.first_estimate_scans);
  core::require(params.threshold > 0.0, "threshold must be > 0", params.threshold);
  core::require_share("support_share", params.support_share);
  core::require(params.min_support >= 3, "min_support must be >= 3", params.min_support);
  core::require(params.max_lines >= 1, "max_lines must be >= 1", params.max_lines);
  core::require(params.max_draws >= 1, "max_draws must be >= 1", params.max_draws);
}

void RansacEstimator::take_scan(const core::PosedScan& scan) {
  if (window_.size() == static_cast<std::size_t>(params_.window_scans))
    std::rotate(window_.begin(), window_.begin() + 1, window_.end());
  else
    window_.emplace_back();
  scan_to_detections(scan, 0, window_.back());
  utimes_.push_back(scan.scan.utime);
  if (utimes_.size() > window_.size()) utimes_.erase(utimes_.begin());
  newest_utime_ = utimes_.back();
  oldest_utime_ = utimes_.front();
  sequence_ = scan.scan.sequence;
}

std::span<const core::MotionElement> RansacEstimator::update(const core::PosedScan& scan) {
  take_scan(scan);
  elements_.clear();
  if (window_.size() < static_cast<std::size_t>(params_.first_estimate_scans)) return elements_;
  std::vector<core::Detection> points;
  for (const auto& detections : window_) points.insert(points.end(), detections.begin(), detections.end());
  for (int line = 0; line < params_.max_lines; ++line) {
    const auto inliers = best_line(points);
    if (inliers.empty()) break;
    std::vector<core::Detection> own;
    own.reserve(inliers.size());
    for (const std::size_t i : inliers) own.push_back(points[i]);
    report(own);
    for (auto i = inliers.rbegin(); i != inliers.rend(); ++i)
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  return elements_;
}

std::vector<std::size_t> RansacEstimator::best_line(const std::vector<core::Detection>& points) {
  const auto needed = std::max<std::size_t>(
      static_cast<std::size_t>(params_.min_support),
      static_cast<std::size_t>(params_.support_share * static_cast<double>(window_.size())));
  if (points.size() < needed) return {};
  Points matrix(2, static_cast<int>(points.size()));
  for (int i = 0; i < matrix.cols(); ++i) {
    matrix(0, i) = points[static_cast<std::size_t>(i)].p_earth.x();
    matrix(1, i) = points[static_cast<std::size_t>(i)].p_earth.y();
  }
  const auto seed = static_cast<std::uint32_t>(seed_ * kSeedFactor + static_cast<std::uint64_t>(sequence_));
  auto inliers = ransac_line(matrix, params_.threshold * sonar_.range_sigma, params_.max_draws, seed);
  std::sort(inliers.begin(), inliers.end());
  return inliers.size() >= needed ? inliers : std::vector<std::size_t>{};
}

// Regression of north and of east over time; too fast is no target.
void RansacEstimator::report(const std::vector<core::Detection>& own) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();  // Columns north and east.
  for (const auto& detection : own) {
    const Eigen::Vector2d basis(1.0, core::seconds(detection.utime - newest_utime_));
    normal += basis * basis.transpose();
    sums += basis * detection.p_earth.transpose();
  }
  const Eigen::LDLT<Eigen::Matrix2d> solver(normal);
  if (!(normal.determinant() > kLeastDeterminant)) return;
  const Eigen::Matrix2d fit = solver.solve(sums);
  const Eigen::Matrix2d spread =
      sonar_.range_sigma * sonar_.range_sigma * solver.solve(Eigen::Matrix2d::Identity());
  core::MotionElement element;
  element.position = fit.row(0).transpose();
  element.velocity = fit.row(1).transpose();
  if (element.velocity.norm() > sonar_.max_speed) return;
  element.initial_utime = oldest_utime_;
  element.initial_position =
      element.position + core::seconds(oldest_utime_ - newest_utime_) * element.velocity;
  for (int axis = 0; axis < 2; ++axis)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) element.covariance(axis + 2 * i, axis + 2 * j) = spread(i, j);
  element.score = static_cast<double>(own.size());
  element.support = static_cast<int>(own.size());
  elements_.push_back(element);
}

}  // namespace lookout::csht
