#include "csht/likelihood/scan_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "csht/likelihood/blurred_likelihood.hpp"
#include "csht/likelihood/range_gate.hpp"
#include "csht/scan_to_detections.hpp"

namespace lookout::csht {
namespace {

// The range of a slot without a return [m]: no position is near it, and silent() knows it.
constexpr float kFar = -1e6F;

// How many sigmas of the heading's error `blur_reach` covers; what lies beyond counts as its outermost beam.
constexpr double kBlurSigmas = 2.0;

struct ReturnWorth {
  double gain = 0.0;                              // Height of the Gaussian where the target's return fits.
  double foreign = 0.0;                           // Likelihood ratio of a return that cannot be the target's.
  double silence = 0.0;                           // Likelihood ratio of a silent beam.
  double foreign_lost = 0.0, silence_lost = 0.0;  // What both gain where the target's return is surely lost.
};

// [Yan2018] V as a likelihood ratio "target here" against "no target here"; each averages 1 over clutter.
ReturnWorth worth_of(const SensorFigures& f, const SensorModelParams& model, double max_range) {
  const double height = max_range / (f.range_sigma * std::sqrt(2.0 * std::numbers::pi));
  const double detect = 1.0 - f.miss_probability;
  ReturnWorth worth;
  if (model.clutter == ClutterModel::exclusive_beam) {
    worth.gain = detect / f.false_alarm_probability * height;
    worth.foreign = std::exp(model.log_floor);
    worth.silence = f.miss_probability / (1.0 - f.false_alarm_probability);
    worth.silence_lost = detect / (1.0 - f.false_alarm_probability);
  } else {  // Of a target's return and a false alarm in one beam, either is reported.
    worth.gain = detect * (1.0 - 0.5 * f.false_alarm_probability) / f.false_alarm_probability * height;
    worth.foreign = 1.0 - 0.5 * detect;
    worth.silence = f.miss_probability;
    worth.foreign_lost = 0.5 * detect;
    worth.silence_lost = detect;
  }
  return worth;
}

// Of a scan that may be lost a silence says less: its likelihood ratio is one if it was.
void excuse_silence(ScanTable& table) {
  for (float& base : table.base) base = table.listened * base + (1.0F - table.listened);
  for (float& lost : table.lost) lost *= table.listened;
}

void set_beam_figures(const SensorFigures& figures, const SensorModelParams& model, ScanTable& table) {
  const ReturnWorth worth = worth_of(figures, model, table.max_range);
  table.gain = static_cast<float>(worth.gain * (1.0 - figures.tail_share));
  table.tail_gain = static_cast<float>(worth.gain * figures.tail_share / SensorFigures::kTailScale);
  table.range_gate = model.range_gate;
  table.range_loss = static_cast<float>(figures.range_loss / (1.0 - figures.miss_probability) /
                                        (table.max_range * table.max_range));
  for (std::size_t slot = 0; slot < table.range.size(); ++slot) {
    const bool silent = table.range[slot] < 0.0F;
    table.base[slot] = static_cast<float>(silent ? worth.silence : worth.foreign);
    table.lost[slot] = static_cast<float>(silent ? worth.silence_lost : worth.foreign_lost);
    if (silent || model.clutter != ClutterModel::exclusive_beam) continue;
    // What stands or is dense in a target's beam returns as well as elsewhere, whenever the target does not.
    const float excess = 1.0F - table.background[slot];
    table.base[slot] += static_cast<float>(figures.miss_probability) * excess;
    table.lost[slot] = static_cast<float>(1.0 - figures.miss_probability) * excess;
  }
  if (table.listened < 1.0F) excuse_silence(table);
  if (table.whole_circle) return;
  table.base.front() = table.base.back() = 1.0F;
  table.lost.front() = table.lost.back() = 0.0F;
}

// Clutter is uniform over range and bearing, as the false alarms of [Yan2018] V are.
void set_point_figures(const SensorFigures& figures, const SensorModelParams& model, ScanTable& table) {
  const double density = figures.clutter_per_scan / (table.max_range * table.num_beams * table.bearing_step);
  const double area = 2.0 * std::numbers::pi * figures.range_sigma * figures.bearing_sigma;
  table.gain = static_cast<float>((1.0 - figures.miss_probability) / (density * area));
  std::fill(table.base.begin(), table.base.end(), static_cast<float>(figures.miss_probability));
  table.range_loss = table.tail_gain = 0.0F;
  const double lost = model.range_gate ? 1.0 - figures.miss_probability : 0.0;
  std::fill(table.lost.begin(), table.lost.end(), static_cast<float>(lost));
  if (table.listened < 1.0F) excuse_silence(table);
  table.inverse_resolution = figures.resolution > 0.0 ? static_cast<float>(1.0 / figures.resolution) : 0.0F;
  table.inverse_bearing_sigma = static_cast<float>(1.0 / figures.bearing_sigma);
}

void set_blur(const SensorFigures& figures, ScanTable& table) {
  const double sigma = table.heading_error ? table.heading_error->sigma : figures.heading_sigma;
  const bool exact = table.clutter == ClutterModel::point || (sigma <= 0.0 && figures.position_sigma <= 0.0);
  table.blur_heading = static_cast<float>(sigma / table.bearing_step);
  table.blur_position = static_cast<float>(figures.position_sigma / table.bearing_step);
  const double narrowest = table.uneven() ? table.fan->narrowest() : table.bearing_step;
  const double heading = kBlurSigmas * sigma / narrowest;
  table.blur_reach = exact ? 0 : std::clamp(static_cast<int>(std::ceil(heading)), 1, kMostBlurReach);
}

void set_axis(double axis, ScanTable& table) {
  table.axis = core::wrap_to_pi(axis);
  table.cos_axis = std::cos(table.axis);
  table.sin_axis = std::sin(table.axis);
}

void fill_slots(ScanTable& table) {
  const auto slots = static_cast<std::size_t>(table.num_beams) + 2;
  table.range.assign(slots, kFar);
  table.base.assign(slots, 1.0F);
  table.lost.assign(slots, 0.0F);
  table.group.assign(slots, std::int16_t{-1});
  table.share.assign(slots, 1.0F);
  table.echo_offset.assign(slots, 0.0F);
  for (std::vector<float>* of_return : {&table.background, &table.loudness, &table.worth})
    of_return->assign(std::max(slots, table.detections.size()), 1.0F);
  table.bearing_from_axis.clear();
  for (const auto& detection : table.detections) {
    table.bearing_from_axis.push_back(static_cast<float>(core::wrap_to_pi(detection.azimuth - table.axis)));
    if (detection.beam < 0 || detection.beam >= table.num_beams) continue;
    float& range = table.range[static_cast<std::size_t>(detection.beam) + 1];
    const auto reported = static_cast<float>(detection.range);
    range = range < 0.0F ? reported : std::min(range, reported);
  }
  if (!table.whole_circle) return;
  table.range.front() = table.range[slots - 2];
  table.range.back() = table.range[1];
}

}  // namespace

int fill_scan_table(const core::PosedScan& posed, ScanTable& table) {
  const core::SonarScan& scan = posed.scan;
  const double sector = scan.fan ? scan.fan->sector() : scan.num_beams * scan.bearing_step;
  table.utime = scan.utime;
  table.T_earth_sonar = posed.T_earth_sonar;
  table.heading_error.reset();
  set_axis(posed.T_earth_sonar.heading + scan.first_bearing + 0.5 * (scan.num_beams - 1) * scan.bearing_step,
           table);
  table.first_bearing = scan.first_bearing;
  table.bearing_step = scan.bearing_step;
  table.fan = scan.fan;
  table.fan_middle = scan.first_bearing + 0.5 * (scan.num_beams - 1) * scan.bearing_step;
  table.max_range = scan.max_range;
  table.num_beams = scan.num_beams;
  table.whole_circle = sector > 2.0 * std::numbers::pi - 0.5 * scan.bearing_step;
  table.cos_half_sector = table.whole_circle ? -1.0 : std::cos(0.5 * sector);
  table.half_sector = static_cast<float>(table.whole_circle ? 2.0 * std::numbers::pi : 0.5 * sector);
  const int left_out = scan_to_detections(posed, 0, table.detections);
  fill_slots(table);
  return left_out;
}

std::optional<std::size_t> slot_of(const ScanTable& scan, std::size_t index) {
  if (scan.clutter == ClutterModel::point) return index;
  const core::Detection& detection = scan.detections[index];
  if (detection.beam < 0 || detection.beam >= scan.num_beams) return std::nullopt;
  const std::size_t slot = static_cast<std::size_t>(detection.beam) + 1;
  if (scan.range[slot] != static_cast<float>(detection.range)) return std::nullopt;
  return slot;
}

void set_figures(const SensorFigures& figures, const SensorModelParams& model, ScanTable& table) {
  std::transform(table.background.begin(), table.background.end(), table.loudness.begin(),
                 table.worth.begin(), std::multiplies<>());
  table.clutter = model.clutter;
  table.inverse_sigma = static_cast<float>(1.0 / figures.range_sigma);
  if (model.clutter == ClutterModel::point)
    set_point_figures(figures, model, table);
  else
    set_beam_figures(figures, model, table);
  set_blur(figures, table);
}

double lost_of(const ScanTable& table, double inverse_sigma, double range) {
  const double out = table.range_gate ? lost_share(table.max_range, inverse_sigma, range) : 0.0;
  return 1.0 - (1.0 - out) * heard_share(static_cast<double>(table.range_loss), range);
}

double peak_of(const ScanTable& table, std::size_t slot, double range, double sigma_scale) {
  const double offset = (range - static_cast<double>(table.range[slot])) *
                        static_cast<double>(table.inverse_sigma) / sigma_scale;
  const double wide = offset / SensorFigures::kTailScale;
  const double peak = static_cast<double>(table.gain) * std::exp(-0.5 * offset * offset) +
                      static_cast<double>(table.tail_gain) * std::exp(-0.5 * wide * wide);
  return peak / sigma_scale * static_cast<double>(table.worth[slot]) *
         heard_share(static_cast<double>(table.range_loss), range);
}

void set_heading_error(const HeadingError& error, const SensorFigures& figures, ScanTable& table) {
  const double turn = error.mean - (table.heading_error ? table.heading_error->mean : 0.0);
  table.heading_error = error;
  table.T_earth_sonar.heading = core::wrap_to_pi(table.T_earth_sonar.heading + turn);
  set_axis(table.axis + turn, table);
  for (core::Detection& detection : table.detections) {
    detection.azimuth = core::wrap_to_pi(detection.azimuth + turn);
    detection.p_earth = detection.p_earth_sonar + core::from_polar(detection.range, detection.azimuth);
  }
  set_blur(figures, table);
}

}  // namespace lookout::csht
