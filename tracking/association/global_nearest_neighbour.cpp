#include "tracking/association/global_nearest_neighbour.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {

GlobalNearestNeighbour::GlobalNearestNeighbour(double gate) : gate_(gate) {
  core::require(gate > 0.0, "gate must be > 0", gate);
}

const std::vector<int>& GlobalNearestNeighbour::assign(const Scene& scene, const core::SonarParams& sonar) {
  noise_.clear();
  for (const auto& detection : scene.detections) noise_.push_back(position_noise(detection, sonar));
  detection_of_track_.assign(scene.tracks.size(), -1);
  find_gated_pairs(scene);
  if (pairs_.empty()) return detection_of_track_;
  fill_cost();
  const auto rows = static_cast<Eigen::Index>(track_of_row_.size());
  const auto columns = static_cast<Eigen::Index>(detection_of_column_.size());
  const auto& column_of_row = solver_.solve(cost_.topLeftCorner(rows, columns));
  for (Eigen::Index row = 0; row < rows; ++row) {
    const int column = column_of_row[static_cast<std::size_t>(row)];
    if (column < 0 || cost_(row, column) >= gate_) continue;
    const auto track = static_cast<std::size_t>(track_of_row_[static_cast<std::size_t>(row)]);
    detection_of_track_[track] = detection_of_column_[static_cast<std::size_t>(column)];
  }
  return detection_of_track_;
}

void GlobalNearestNeighbour::find_gated_pairs(const Scene& scene) {
  pairs_.clear();
  track_of_row_.clear();
  detection_of_column_.clear();
  column_of_detection_.assign(scene.detections.size(), -1);
  for (std::size_t track = 0; track < scene.tracks.size(); ++track) {
    if (scene.use_track[track]) find_gated_pairs_of(scene, track);
  }
}

void GlobalNearestNeighbour::find_gated_pairs_of(const Scene& scene, std::size_t track) {
  const Eigen::Matrix2d spread = scene.tracks[track].covariance.topLeftCorner<2, 2>();
  const Eigen::Vector2d position = scene.tracks[track].position();
  bool has_row = false;
  for (std::size_t j = 0; j < scene.detections.size(); ++j) {
    if (!scene.use_detection[j]) continue;
    const double distance = squared_distance(scene.detections[j].p_earth - position, spread + noise_[j]) +
                            (scene.worth.empty() ? 0.0 : scene.worth[j].penalty);
    if (distance >= gate_) continue;
    if (!has_row) track_of_row_.push_back(static_cast<int>(track));
    has_row = true;
    if (column_of_detection_[j] < 0) {
      column_of_detection_[j] = static_cast<int>(detection_of_column_.size());
      detection_of_column_.push_back(static_cast<int>(j));
    }
    pairs_.push_back({static_cast<int>(track_of_row_.size()) - 1, column_of_detection_[j], distance});
  }
}

void GlobalNearestNeighbour::fill_cost() {
  const auto rows = static_cast<Eigen::Index>(track_of_row_.size());
  const auto columns = static_cast<Eigen::Index>(detection_of_column_.size());
  // Grown in steps that double, so that a warm caller allocates nothing.
  if (cost_.rows() < rows || cost_.cols() < columns)
    cost_.resize(std::max(2 * rows, cost_.rows()), std::max(2 * columns, cost_.cols()));
  cost_.topLeftCorner(rows, columns).setConstant(gate_);
  for (const auto& pair : pairs_) cost_(pair.row, pair.column) = pair.distance;
}

}  // namespace lookout::tracking
