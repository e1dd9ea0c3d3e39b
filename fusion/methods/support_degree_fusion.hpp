#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fusion/hough_point.hpp"
#include "fusion/methods/scalar_weight_fusion.hpp"

namespace lookout::fusion {

/// Over which distances the largest is taken, which the paper leaves open: `any` two points of this global
/// track (all pairs among its tracklets and its own), `col` only tracklet to global, `all` points of the
/// scan.
enum class SupportReading { any, col, all };

/// How the paper's support degrees are read where its text leaves it open.
struct SupportDegreeParams {
  SupportReading reading = SupportReading::any;  ///< Which points' spread scales the degrees.
  double length_unit = 1000.0;  ///< Metres that weigh as one radian, > 0: 1000 (km) or 1 (m). docs/fusion.md.
  Eigen::Vector2d p_earth_origin{0, 0};  ///< Where rho is measured from: north, east [m].
};

/// Weights by the support degree function: the nearer a tracklet's line to that of the global track in Hough
/// space, the more weight. To the letter, flaws included (docs/fusion.md). [Li2018] Eq. (3)-(7), (14)-(19).
class SupportDegreeFusion final : public ScalarWeightFusion {
 public:
  /// @throws std::invalid_argument on a unit that is not positive.
  explicit SupportDegreeFusion(const SupportDegreeParams& params, const LearnedGeometryParams& errors = {});

 private:
  using Points = std::vector<std::optional<HoughPoint>>;

  void look_at_all(std::span<const TrackGroup> groups) override;
  void support(const TrackGroup& group, std::vector<double>& support) override;
  /// Puts the group's own point, then those of its contributions at the end of `points`.
  void append_points(const TrackGroup& group, Points& points) const;
  double largest_pair(const Points& points) const;

  SupportDegreeParams params_;
  Points points_;
  double largest_of_scan_ = 0.0;
};

/// The repaired weights: residuals across and along the track and of the course, all in metres about the
/// predicted position, and a support that neither vanishes nor is linear. docs/fusion.md, `sdf_fixed`.
class SupportDegreeFixed final : public ScalarWeightFusion {
 public:
  /// @param errors where learning of the nodes' errors begins.
  explicit SupportDegreeFixed(const LearnedGeometryParams& errors = {}) : ScalarWeightFusion(errors) {}

 private:
  void support(const TrackGroup& group, std::vector<double>& support) override;

  std::vector<double> sorted_;
};

}  // namespace lookout::fusion
