#include "tracking/track_before_detect/frames/spot_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"
#include "tracking/track_before_detect/frames/local_contrast.hpp"
#include "tracking/track_before_detect/frames/scene_motion.hpp"

namespace lookout::tracking {
namespace {

constexpr std::size_t kPeaks = 40;     // of a frame that are looked at
constexpr std::size_t kFirstPeak = 5;  // from which peaks are background
constexpr std::size_t kLastPeak = 30;  // up to which their fall is measured
constexpr double kLeastSlope = 0.05;   // of a frame whose peaks are all equal
constexpr double kSamePlace = 3.0;     // [px] in which contrast and motion are of one spot
constexpr double kApart = 5.0;         // [px] in which no second spot starts
constexpr double kStartShare = 0.5;    // of its evidence that a new spot starts with
constexpr double kVelocityMemory = 0.7;
constexpr double kVelocityGain = 0.15;
constexpr double kMissGate = 2.0;  // [px] by which the gate widens with each miss
constexpr double kWorst = -2.0;    // evidence less distance below which nothing is taken
constexpr int kKnown = 5;          // frames after which a spot is known

double value_at(const std::vector<PixelPeak>& peaks, std::size_t rank) {
  return rank <= peaks.size() ? peaks[rank - 1].value : 0.0;
}

}  // namespace

SpotTracker::SpotTracker(const SpotParams& params) : params_(params) {
  core::require(params.lag >= 1, "lag must be >= 1", params.lag);
  core::require(params.first_lag >= 1, "first_lag must be >= 1", params.first_lag);
  core::require_positive("most_evidence", params.most_evidence);
  core::require(params.evidence_memory > 0.0 && params.evidence_memory < 1.0,
                "evidence_memory must be in (0, 1)", params.evidence_memory);
  core::require_positive("confirm_evidence", params.confirm_evidence);
  core::require_positive("gate", params.gate);
  core::require_positive("gate_of_clear", params.gate_of_clear);
  core::require_positive("clear_evidence", params.clear_evidence);
  core::require_positive("distance_cost", params.distance_cost);
}

const std::vector<Spot>& SpotTracker::update(std::span<const double> grey, int columns, int rows,
                                             double step) {
  remember(grey);
  find(columns, rows);
  follow(step);
  end_and_start();
  for (Spot& spot : spots_)
    spot.confirmed = spot.frames >= params_.confirm_frames && spot.evidence > params_.confirm_evidence;
  return spots_;
}

void SpotTracker::remember(std::span<const double> grey) {
  frames_.emplace_back(grey.begin(), grey.end());
  if (params_.polarity == Polarity::dark)
    for (double& value : frames_.back()) value = -value;
  if (frames_.size() > static_cast<std::size_t>(params_.lag) + 1) frames_.pop_front();
}

void SpotTracker::find(int columns, int rows) {
  findings_.clear();
  add(pixel_peaks(local_contrast(frames_.back(), columns, rows), columns, rows, kPeaks), &Finding::contrast);
  if (frames_.size() > static_cast<std::size_t>(params_.first_lag))
    add(pixel_peaks(scene_residual(frames_.front(), frames_.back(), columns, rows), columns, rows, kPeaks),
        &Finding::motion);
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const Finding& a, const Finding& b) { return a.evidence() > b.evidence(); });
}

/// Takes the peaks that lie beyond the exponential fall of the frame's others.
void SpotTracker::add(const std::vector<PixelPeak>& peaks, double Finding::*kind) {
  const double start = value_at(peaks, kFirstPeak);
  const double fall = std::log(static_cast<double>(kLastPeak) / kFirstPeak);
  const double slope = std::max(kLeastSlope, (start - value_at(peaks, kLastPeak)) / fall);
  for (const PixelPeak& peak : peaks) {
    const double evidence = (peak.value - start) / slope - std::log(static_cast<double>(kFirstPeak));
    if (evidence <= 0.0) return;
    const Eigen::Vector2d position(peak.x, peak.y);
    auto same = std::find_if(findings_.begin(), findings_.end(), [&](const Finding& f) {
      return f.*kind == 0.0 && (f.position - position).norm() < kSamePlace;
    });
    if (same == findings_.end()) same = findings_.insert(same, {position, 0.0, 0.0, false});
    (*same).*kind = std::min(params_.most_evidence, evidence);
  }
}

SpotTracker::Finding* SpotTracker::choose(const Spot& spot, const Eigen::Vector2d& predicted) {
  Finding* best = nullptr;
  double highest = kWorst;
  for (Finding& finding : findings_) {
    const double distance = (finding.position - predicted).norm();
    const bool clear = finding.evidence() > params_.clear_evidence;
    const double gate = (clear ? params_.gate_of_clear : params_.gate) + kMissGate * spot.misses;
    const double value = finding.evidence() - distance * distance / params_.distance_cost;
    if (finding.used || distance >= gate || value <= highest) continue;
    highest = value;
    best = &finding;
  }
  return best;
}

/// The surest spot chooses first.
void SpotTracker::follow(double step) {
  std::stable_sort(spots_.begin(), spots_.end(),
                   [](const Spot& a, const Spot& b) { return a.evidence > b.evidence; });
  for (Spot& spot : spots_) {
    const Eigen::Vector2d predicted = spot.position + step * spot.velocity;
    Finding* finding = choose(spot, predicted);
    spot.evidence *= params_.evidence_memory;
    if (finding == nullptr) {
      spot.position = predicted;
      ++spot.misses;
      continue;
    }
    finding->used = true;
    spot.velocity = kVelocityMemory * spot.velocity +
                    kVelocityGain / std::max(step, 1.0) * (finding->position - spot.position);
    spot.position = finding->position;
    spot.evidence += (1.0 - params_.evidence_memory) * finding->evidence();
    spot.misses = 0;
    ++spot.frames;
  }
}

void SpotTracker::end_and_start() {
  std::erase_if(spots_, [this](const Spot& spot) {
    return spot.misses >= (spot.frames > kKnown ? params_.most_misses : params_.few_misses);
  });
  for (const Finding& finding : findings_) {
    const bool known = finding.used || std::any_of(spots_.begin(), spots_.end(), [&](const Spot& spot) {
                         return (spot.position - finding.position).norm() < kApart;
                       });
    if (known) continue;
    Spot spot;
    spot.id = next_id_++;
    spot.position = finding.position;
    spot.evidence = kStartShare * finding.evidence();
    spot.frames = 1;
    spots_.push_back(spot);
  }
}

}  // namespace lookout::tracking
