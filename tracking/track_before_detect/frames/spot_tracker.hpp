#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "tracking/track_before_detect/frames/pdim.hpp"
#include "tracking/track_before_detect/frames/pixel_filters.hpp"

namespace lookout::tracking {

/// How spots are linked. One set for all sequences: chosen on three real infrared ones.
struct SpotParams {
  Polarity polarity = Polarity::bright;  ///< See Polarity.
  int lag = 8;                    ///< Frames between the two in which motion against the scene shows, >= 1.
  int first_lag = 5;              ///< And at least so many, at the start, >= 1.
  double most_evidence = 12.0;    ///< That one frame gives in either way, > 0.
  double evidence_memory = 0.93;  ///< Of the mean evidence, per frame, in (0, 1).
  double confirm_evidence = 2.0;  ///< Mean evidence of a confirmed spot, > 0.
  int confirm_frames = 3;         ///< With evidence, at least, >= 1.
  double gate = 4.0;              ///< Of a spot about its prediction [px], > 0.
  double gate_of_clear = 20.0;    ///< Of one that is clear by itself: a hand-held camera jerks [px], > 0.
  double clear_evidence = 4.0;    ///< From which a spot is clear, > 0.
  double distance_cost = 12.0;    ///< Squared distance that costs one unit of evidence [px^2], > 0.
  int most_misses = 8;            ///< In a row, of a spot known for more than five frames, >= 1.
  int few_misses = 3;             ///< Of one that is newer, >= 1.
};

/// One spot at one frame.
struct Spot {
  std::int64_t id = 0;             ///< Never used again.
  Eigen::Vector2d position{0, 0};  ///< [px], pixel centres at .5.
  Eigen::Vector2d velocity{0, 0};  ///< [px a frame].
  double evidence = 0.0;           ///< Mean over the frames: -ln of how many such are expected in a frame.
  int frames = 0;                  ///< With evidence.
  int misses = 0;                  ///< In a row.
  bool confirmed = false;          ///< At this frame.
};

/// Finds small targets in grey frames without a start: by how they stand out of their surroundings
/// (local_contrast) and by how they move against the scene (scene_residual). Either way what counts is how
/// far a peak lies beyond what the frame's other peaks, from the fifth to the thirtieth, let expect; so that
/// four targets may be there and no threshold belongs to a sequence.
class SpotTracker {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit SpotTracker(const SpotParams& params = {});

  /// Takes the next frame of grey levels, `step` frames after the one before. Valid until the next call.
  const std::vector<Spot>& update(std::span<const double> grey, int columns, int rows, double step);

 private:
  struct Finding {
    Eigen::Vector2d position{0, 0};
    double contrast = 0.0;  ///< Evidence >= 0.
    double motion = 0.0;    ///< Evidence >= 0.
    bool used = false;
    double evidence() const { return contrast + motion; }
  };
  void remember(std::span<const double> grey);
  void find(int columns, int rows);
  void add(const std::vector<PixelPeak>& peaks, double Finding::*kind);
  void follow(double step);
  Finding* choose(const Spot& spot, const Eigen::Vector2d& predicted);
  void end_and_start();

  SpotParams params_;
  std::deque<std::vector<double>> frames_;  ///< The newest last.
  std::vector<Finding> findings_;
  std::vector<Spot> spots_;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
