#include "sonar_sim/video_stand_in.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"

namespace lookout::sonar_sim {
namespace {

constexpr int kSubsamples = 4;             // per axis and pixel, for the coverage of partly covered pixels
constexpr double kSkyTop = 210.0;          // grey level at the upper edge
constexpr double kSkyBottom = 190.0;       // and at the lower one
constexpr double kTreeShare = 0.1;         // of the frame's height
constexpr double kSilhouetteArea = 0.175;  // of the unit silhouette: length = sqrt(area / 0.175)
constexpr int kCloudWaves = 24;            // sinusoids of the cloud texture
constexpr double kShortestWave = 20.0, kLongestWave = 100.0;  // [px]
constexpr int kTextureMargin = 40;                            // columns beyond the frame that the drift needs

constexpr double kLeastVariance = 1e-30;  // of a texture that is scaled: a flat one stays flat
// The aircraft in units of its length, nose at x = 0.5: half axes of the fuselage; of wing and fin the height
// and the edges, leading and trailing: at y = 0, then at the tip.
constexpr double kFuselageLength = 0.5, kFuselageWidth = 0.055;
constexpr double kWingSpan = 0.33, kFinHeight = 0.22;
constexpr std::array kWing{-0.18, 0.17, -0.30, -0.16}, kFin{-0.49, -0.34, -0.50, -0.41};
constexpr double kPathMiddle = 0.05;  // how far from the middle of the frame the path's may lie [sides]

/// Whether `x` lies in the swept quadrilateral between its edges at y = 0 and y = height.
bool in_swept(double x, double y, double height, std::array<double, 4> edges) {
  const double t = y / height;
  if (t < 0.0 || t > 1.0) return false;
  return x >= edges[0] + t * (edges[2] - edges[0]) && x <= edges[1] + t * (edges[3] - edges[1]);
}

/// Share of each pixel for which `covers(p)`, for pixels of the box alone; 0 elsewhere.
template <typename Covers>
void rasterise(int size, const PixelBox& box, const Covers& covers, std::vector<double>& coverage) {
  const auto bound = [size](double v) { return std::clamp(static_cast<int>(std::floor(v)), 0, size); };
  for (int row = bound(box.low.y()); row < bound(box.high.y() + 1.0); ++row)
    for (int column = bound(box.low.x()); column < bound(box.high.x() + 1.0); ++column) {
      int hits = 0;
      for (int i = 0; i < kSubsamples * kSubsamples; ++i) {
        const Eigen::Vector2d offset(i % kSubsamples + 0.5, i / kSubsamples + 0.5);
        hits += covers(Eigen::Vector2d(column, row) + offset / kSubsamples) ? 1 : 0;
      }
      double& share = coverage[static_cast<std::size_t>(row * size + column)];
      share = std::max(share, hits / static_cast<double>(kSubsamples * kSubsamples));
    }
}

PixelBox square_around(const Eigen::Vector2d& centre, double half) {
  return {centre.array() - half, centre.array() + half};
}

Eigen::Vector2d centroid_of(const std::vector<double>& coverage, int size) {
  Eigen::Vector2d sum{0, 0};
  double total = 0.0;
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const auto n = static_cast<std::size_t>(size);
    sum += coverage[i] * Eigen::Vector2d(static_cast<double>(i % n) + 0.5, static_cast<double>(i / n) + 0.5);
    total += coverage[i];
  }
  return total > 0.0 ? Eigen::Vector2d(sum / total) : Eigen::Vector2d(0, 0);
}

PixelBox box_of(const std::vector<double>& coverage, int size) {
  PixelBox box{{size, size}, {0, 0}};
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    if (coverage[i] <= 0.0) continue;
    const auto n = static_cast<std::size_t>(size);
    const Eigen::Vector2d corner(static_cast<double>(i % n), static_cast<double>(i / n));
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax((corner.array() + 1.0).matrix());
  }
  return box;
}

/// Bilinear value of a texture at (x, y) >= 0, its edges repeated.
double sample_texture(const std::vector<double>& texture, int columns, int rows, double x, double y) {
  constexpr double kInside = 1.001;  // The last point between two pixels, a hair from the last pixel.
  x = std::clamp(x, 0.0, columns - kInside);
  y = std::clamp(y, 0.0, rows - kInside);
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const double fx = x - column, fy = y - row;
  const auto at = [&](int c, int r) { return texture[static_cast<std::size_t>(r * columns + c)]; };
  return (1 - fy) * ((1 - fx) * at(column, row) + fx * at(column + 1, row)) +
         fy * ((1 - fx) * at(column, row + 1) + fx * at(column + 1, row + 1));
}

void scale_to_sigma(std::vector<double>& texture, double sigma) {
  double sum = 0.0, squares = 0.0;
  for (const double value : texture) sum += value, squares += value * value;
  const double n = static_cast<double>(texture.size());
  const double mean = sum / n, deviation = std::sqrt(std::max(squares / n - mean * mean, kLeastVariance));
  for (double& value : texture) value = sigma * (value - mean) / deviation;
}

void check(const VideoStandInParams& p) {
  core::require(p.num_samples >= 2, "num_samples must be >= 2", p.num_samples);
  core::require_not_negative("cloud_sigma", p.cloud_sigma);
  core::require_not_negative("tree_sigma", p.tree_sigma);
  core::require_not_negative("jitter", p.jitter);
  core::require_not_negative("camera_sigma", p.camera_sigma);
  core::require(std::isfinite(p.cloud_drift), "cloud_drift must be finite", p.cloud_drift);
  core::require_not_negative("sway", p.sway);
  core::require_not_negative("max_heading", p.max_heading);
  core::require_not_negative("mover_offset", p.mover_offset);
  core::require(p.num_movers >= 0, "num_movers must be >= 0", p.num_movers);
  core::require(p.mover_area > 0.0, "mover_area must be > 0", p.mover_area);
}

}  // namespace

double VideoScenario::noise_level() const {
  return std::pow(10.0, noise_db / 10.0);
}

double VideoScenario::contrast() const {
  const double root = noise_level() * std::pow(10.0, snr_db / 10.0);
  return root * root;
}

const std::array<VideoScenario, 8>& video_scenarios() {
  static const std::array<VideoScenario, 8> kScenarios{{{1, 4, 250, 240, 2.5, 1.0, 8.8},
                                                        {2, 3, 300, 126, 3.8, 0.75, 8.9},
                                                        {3, 3, 250, 280, 3.3, 0.0, 9.89},
                                                        {4, 2, 200, 78, 3.0, 0.0, 8.54},
                                                        {5, 2, 200, 88, 2.5, 0.67, 8.3},
                                                        {6, 3, 250, 40, 1.35, 0.98, 9.74},
                                                        {7, 3, 250, 434, 3.5, 1.15, 9.93},
                                                        {8, 2, 250, 450, 4.23, 0.0, 9.8}}};
  return kScenarios;
}

VideoStandInParams plain_video() {
  return {};
}

VideoStandInParams hard_video() {
  VideoStandInParams params;
  params.jitter = 1.0;
  params.num_movers = 3;
  return params;
}

bool silhouette_covers(const Eigen::Vector2d& p) {
  const double x = p.x(), y = p.y();
  const bool fuselage =
      x * x / (kFuselageLength * kFuselageLength) + y * y / (kFuselageWidth * kFuselageWidth) <= 1.0;
  return fuselage || in_swept(x, y, kWingSpan, kWing) || in_swept(x, -y, kFinHeight, kFin);
}

VideoStandIn::VideoStandIn(const VideoScenario& scenario, const VideoStandInParams& params,
                           core::Random& random)
    : scenario_(scenario), params_(params), length_(std::sqrt(scenario.area / kSilhouetteArea)) {
  check(params);
  const double drift = params.cloud_drift * scenario.frame_step * params.num_samples;
  texture_columns_ = scenario.size + kTextureMargin + static_cast<int>(std::ceil(std::abs(drift)));
  lay_path(random);
  lay_movers(random);
  paint_clouds(random);
  paint_trees(random);
}

/// The path's middle lies within a twentieth of the frame's side of the middle of the frame.
void VideoStandIn::lay_path(core::Random& random) {
  const double heading = random.uniform(-params_.max_heading, params_.max_heading);
  direction_ = {std::cos(heading), std::sin(heading)};
  const double length = scenario_.speed * scenario_.frame_step * (params_.num_samples - 1);
  const double side = scenario_.size;
  const Eigen::Vector2d middle(0.5 * side, 0.5 * side + random.uniform(-kPathMiddle, kPathMiddle) * side);
  start_ = middle - 0.5 * length * direction_;
}

void VideoStandIn::lay_movers(core::Random& random) {
  for (int i = 0; i < params_.num_movers; ++i) {
    Mover mover;
    mover.sample = (i + 1) * params_.num_samples / (params_.num_movers + 1);
    mover.crossing = position(mover.sample) + Eigen::Vector2d(random.gaussian(params_.mover_offset),
                                                              random.gaussian(params_.mover_offset));
    const double side = random.bernoulli(0.5) ? 1.0 : -1.0;
    mover.velocity = side * scenario_.speed * Eigen::Vector2d(-direction_.y(), direction_.x());
    movers_.push_back(mover);
  }
}

void VideoStandIn::paint_clouds(core::Random& random) {
  const int rows = scenario_.size;
  clouds_.assign(static_cast<std::size_t>(texture_columns_ * rows), 0.0);
  for (int wave = 0; wave < kCloudWaves; ++wave) {
    const double number = 2.0 * std::numbers::pi / random.uniform(kShortestWave, kLongestWave);
    const double angle = random.uniform(0.0, std::numbers::pi);
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double kx = number * std::cos(angle), ky = number * std::sin(angle);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < texture_columns_; ++column)
        clouds_[static_cast<std::size_t>(row * texture_columns_ + column)] +=
            std::sin(kx * column + ky * row + phase);
  }
  scale_to_sigma(clouds_, params_.cloud_sigma);
}

/// White noise averaged over 3 x 3 pixels: leaves and branches of a few pixels.
void VideoStandIn::paint_trees(core::Random& random) {
  const int rows = scenario_.size;
  std::vector<double> white(static_cast<std::size_t>(texture_columns_ * rows));
  for (double& value : white) value = random.gaussian();
  trees_ = white;
  for (int row = 1; row + 1 < rows; ++row)
    for (int column = 1; column + 1 < texture_columns_; ++column) {
      double sum = 0.0;
      for (int i = 0; i < 9; ++i)
        sum += white[static_cast<std::size_t>((row + i / 3 - 1) * texture_columns_ + column + i % 3 - 1)];
      trees_[static_cast<std::size_t>(row * texture_columns_ + column)] = sum / 3.0;
    }
  scale_to_sigma(trees_, params_.tree_sigma);
}

Eigen::Vector2d VideoStandIn::position(int sample) const {
  const double way = scenario_.speed * scenario_.frame_step * sample;
  const double phase = std::numbers::pi * sample / (params_.num_samples - 1);
  const Eigen::Vector2d across(-direction_.y(), direction_.x());
  return start_ + way * direction_ + params_.sway * std::sin(phase) * across;
}

Eigen::Vector2d VideoStandIn::velocity(int sample) const {
  const double rate = std::numbers::pi / ((params_.num_samples - 1) * scenario_.frame_step);
  const double phase = std::numbers::pi * sample / (params_.num_samples - 1);
  const Eigen::Vector2d across(-direction_.y(), direction_.x());
  return scenario_.speed * direction_ + params_.sway * rate * std::cos(phase) * across;
}

std::vector<double> VideoStandIn::background(int sample, core::Random& random) const {
  const int size = scenario_.size;
  const double drift = params_.cloud_drift * scenario_.frame_step * sample;
  const double shift_x = random.gaussian(params_.jitter), shift_y = random.gaussian(params_.jitter);
  const int first_tree_row = static_cast<int>(size * (1.0 - kTreeShare));
  std::vector<double> grey(static_cast<std::size_t>(size * size));
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      double value = kSkyTop + (kSkyBottom - kSkyTop) * row / size;
      value += sample_texture(clouds_, texture_columns_, size, column + drift, row);
      if (row >= first_tree_row)
        value += sample_texture(trees_, texture_columns_, size, column + 0.5 * kTextureMargin + shift_x,
                                row + shift_y);
      grey[static_cast<std::size_t>(row * size + column)] = value;
    }
  return grey;
}

VideoStandIn::Coverage VideoStandIn::aircraft(int sample) const {
  Coverage coverage(static_cast<std::size_t>(scenario_.size * scenario_.size), 0.0);
  const Eigen::Vector2d centre = position(sample), along = velocity(sample).normalized();
  const auto covers = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d d = (p - centre) / length_;
    return silhouette_covers({d.dot(along), along.x() * d.y() - along.y() * d.x()});
  };
  rasterise(scenario_.size, square_around(centre, 0.6 * length_), covers, coverage);
  return coverage;
}

VideoStandIn::Coverage VideoStandIn::movers(int sample) const {
  Coverage coverage(static_cast<std::size_t>(scenario_.size * scenario_.size), 0.0);
  const double radius = std::sqrt(params_.mover_area / std::numbers::pi);
  for (const Mover& mover : movers_) {
    const Eigen::Vector2d centre =
        mover.crossing + mover.velocity * (sample - mover.sample) * scenario_.frame_step;
    const auto covers = [&](const Eigen::Vector2d& p) { return (p - centre).norm() <= radius; };
    rasterise(scenario_.size, square_around(centre, radius + 1.0), covers, coverage);
  }
  return coverage;
}

VideoSample VideoStandIn::render(int sample, core::Random& random) const {
  VideoSample video;
  video.grey = background(sample, random);
  const Coverage body = aircraft(sample), others = movers(sample);
  for (std::size_t i = 0; i < video.grey.size(); ++i)
    video.grey[i] +=
        random.gaussian(params_.camera_sigma) - scenario_.contrast() * std::max(body[i], others[i]);
  video.centroid = centroid_of(body, scenario_.size);
  video.box = box_of(body, scenario_.size);
  Coverage fresh = body;
  if (sample > 0) {
    const Coverage before = aircraft(sample - 1);
    for (std::size_t i = 0; i < fresh.size(); ++i) fresh[i] = std::max(0.0, body[i] - before[i]);
  }
  video.new_centroid = centroid_of(fresh, scenario_.size);
  return video;
}

}  // namespace lookout::sonar_sim
