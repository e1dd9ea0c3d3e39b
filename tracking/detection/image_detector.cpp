#include "tracking/detection/image_detector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/sonar_limits.hpp"
#include "tracking/detection/one_return.hpp"
#include "tracking/detection/peak_finder.hpp"
#include "tracking/detection/peak_interpolation.hpp"

namespace lookout::tracking {
namespace {

constexpr int kFirstPings = 10;        // The speckle's grain is measured in each of a geometry's first pings,
constexpr int kPingsBetween = 10;      // and then once in so many.
constexpr double kOtherExtent = 0.25;  // Relative change of the extent from which windows are laid anew.
constexpr float kLeastLevel = 1e-3F;   // Least reference level, in the image's mean: few bits leave it at 0.
// Standard deviations of a return's range and bearing in extents of the echo, as measured
// (docs/detect.md) from the threshold on upwards.
constexpr double kRangeSigma = 0.25, kBearingSigma = 0.25;
constexpr std::size_t kMostPeaks = 4;    // Times the most returns: so many peaks are sorted into echoes.
constexpr double kPeaksOfZone = 1000.0;  // Peaks a ping that a range zone needs for a law of its own.
// Targets nearer to each other than so many extents give one return in half of the pings.
constexpr double kResolved = 1.5;
constexpr double kMiddle = 0.5;  // Share of the range at which a beam's width is stated in metres.

CellReach half_of(const CellReach& widths) {
  return {std::max(1, (widths.beams + 1) / 2), std::max(1, (widths.bins + 1) / 2)};
}

double decibel(double power_ratio) {
  return 10.0 * std::log10(power_ratio);
}

bool differs(double a, double b) {
  return std::abs(a - b) > kOtherExtent * b;
}

/// Copies all that a scan says but its returns, of which it leaves none.
void describe(const core::SonarImage& image, const ImageGeometry& geometry, core::SonarScan& scan) {
  scan.utime = image.utime;
  scan.sequence = image.sequence;
  scan.sensor_id = image.sensor_id;
  scan.T_body_sonar = image.T_body_sonar;
  scan.num_beams = geometry.num_beams();
  scan.first_bearing = geometry.bearings.front();
  scan.bearing_step = geometry.spacing();
  scan.max_range = geometry.range_at(geometry.num_bins - 0.5);
  scan.returns.clear();
}

}  // namespace

ImageDetector::ImageDetector(const DetectionParams& params)
    : params_((check(params), params)),
      background_(params.background, params.values),
      reference_(make_reference_level(params.reference)) {}

const core::SonarScan& ImageDetector::detect(const core::SonarImage& image) {
  begin_ping(image);
  ImagePlane& plane = background_.normalise(image.intensity, geometry_.num_beams(), geometry_.num_bins);
  measure_extent(plane);
  filter_.apply(window_.smoothing, plane);
  find_peaks(plane, window_.peak, peaks_);
  compare_with_reference(plane);
  keep_above_threshold();
  leave_one_peak_an_echo(plane, extent_, params_.echo, peaks_);
  give_returns(plane);
  return scan_;
}

/// Describes the scan by the image; another geometry forgets what was learnt in the old one.
void ImageDetector::begin_ping(const core::SonarImage& image) {
  copy_geometry(image, next_geometry_);
  if (!(next_geometry_ == geometry_)) {
    std::swap(geometry_, next_geometry_);
    begin_geometry();
  }
  describe(image, geometry_, scan_);
  ++pings_;
  ++counts_.images;
}

void ImageDetector::begin_geometry() {
  pings_ = 0;
  background_.forget();
  grain_.forget();
}

/// The extent of an echo: of pulse and beam where the user states them, else of the speckle's grain.
void ImageDetector::measure_extent(const ImagePlane& plane) {
  const EchoParams& told = params_.echo;
  if (pings_ > kFirstPings && pings_ % kPingsBetween != 0) return;
  EchoExtent extent;
  if (!told.pulse_length || !told.beam_width) {
    grain_.add(plane);
    extent = grain_.extent();
  }
  if (told.pulse_length) extent.bins = std::max(1.0, *told.pulse_length / geometry_.range_step);
  if (told.beam_width) extent.beams = std::max(1.0, *told.beam_width / geometry_.spacing());
  if (pings_ == 1 || differs(extent.bins, extent_.bins) || differs(extent.beams, extent_.beams)) use(extent);
}

/// Lays the windows for an extent; the peaks of other windows follow another law, which is learnt anew.
void ImageDetector::use(const EchoExtent& extent) {
  extent_ = extent;
  window_ = window_for(extent, params_.reference, geometry_.num_beams(), geometry_.num_bins);
  const double area = (2.0 * window_.peak.beams + 1.0) * (2.0 * window_.peak.bins + 1.0);
  const double peaks = geometry_.num_beams() * static_cast<double>(geometry_.num_bins) / area;
  const double zones = std::clamp(std::floor(peaks / kPeaksOfZone), 1.0, 1.0 * params_.false_alarm.zones);
  laws_.assign(static_cast<std::size_t>(zones), PeakLaw(params_.false_alarm.memory_pings));
  thresholds_.assign(laws_.size(), 0.0);
}

std::size_t ImageDetector::zone_of(int bin) const {
  return static_cast<std::size_t>(bin) * thresholds_.size() / static_cast<std::size_t>(geometry_.num_bins);
}

void ImageDetector::compare_with_reference(const ImagePlane& plane) {
  reference_->prepare(plane, window_);
  for (auto& law : laws_) law.begin_ping();
  for (auto& peak : peaks_) {
    peak.ratio = peak.value / std::max(kLeastLevel, reference_->at(peak.beam, peak.bin));
    laws_[zone_of(peak.bin)].add(peak.ratio);
  }
}

/// Keeps of very many peaks the strongest, from which the returns are taken.
void ImageDetector::keep_strongest() {
  const std::size_t most = kMostPeaks * static_cast<std::size_t>(params_.max_returns);
  if (peaks_.size() <= most) return;
  const auto end = peaks_.begin() + static_cast<std::ptrdiff_t>(most);
  std::nth_element(peaks_.begin(), end, peaks_.end(),
                   [](const auto& a, const auto& b) { return a.value > b.value; });
  counts_.left_out += static_cast<std::int64_t>(peaks_.size() - most);
  peaks_.erase(end, peaks_.end());
}

void ImageDetector::keep_above_threshold() {
  const double zones = static_cast<double>(laws_.size());
  for (std::size_t zone = 0; zone < laws_.size(); ++zone)
    thresholds_[zone] = laws_[zone].threshold(params_.false_alarm.rate * geometry_.num_beams() / zones);
  std::erase_if(peaks_, [this](const PlanePeak& peak) {
    return static_cast<double>(peak.ratio) < thresholds_[zone_of(peak.bin)];
  });
  keep_strongest();
}

void ImageDetector::give_returns(const ImagePlane& plane) {
  const CellReach reach = half_of(window_.smoothing);
  for (const PlanePeak& peak : peaks_) {
    const PeakPlace place = interpolate(plane, peak, reach);
    const double range = geometry_.range_at(place.bin);
    if (!(range > 0.0)) continue;  // The sonar itself.
    scan_.returns.push_back({geometry_.bearing_at(place.beam), range, decibel(peak.ratio * place.gain)});
  }
  const std::size_t most = static_cast<std::size_t>(params_.max_returns);
  if (scan_.returns.size() > most) {
    counts_.left_out += static_cast<std::int64_t>(scan_.returns.size() - most);
    scan_.returns.resize(most);
  }
  counts_.returns += static_cast<std::int64_t>(scan_.returns.size());
}

core::SonarParams ImageDetector::sensor_figures(const core::SonarParams& params) const {
  core::SonarParams figures = params;
  const double length = extent_.bins * geometry_.range_step, width = extent_.beams * geometry_.spacing();
  figures.false_alarm_probability.reset();
  figures.clutter_per_scan = params_.false_alarm.rate * geometry_.num_beams();
  using Limits = core::SonarLimits;
  figures.range_sigma = std::clamp(kRangeSigma * length, Limits::kMinRangeSigma, Limits::kMaxRangeSigma);
  figures.bearing_sigma = kBearingSigma * width;
  figures.resolution = kResolved * std::max(length, kMiddle * width * geometry_.range_at(geometry_.num_bins));
  return figures;
}

}  // namespace lookout::tracking
