#include "csht/likelihood/clutter/local_clutter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"
#include "csht/likelihood/clutter/clutter_grid.hpp"
#include "csht/likelihood/clutter/echo_prices.hpp"
#include "csht/likelihood/sensor_units.hpp"
#include "csht/scan_to_detections.hpp"

namespace lookout::csht {
namespace {

// P_F before anything is known, and the beams that this counts for; of a sensor without beams they are scans.
constexpr double kUnknownFalseAlarm = 0.2, kUnknownBeams = 4.0;
constexpr double kLeastInformation =
    0.5;                         // Where clutter is so dense that returns tell next to nothing [nats].
constexpr int kMostScans = 200;  // That are kept, whatever the sensor's pace.

// As many scans as show that a track surely moves, and those until it is asked.
int scans_kept(const LocalClutterParams& params, const core::SonarParams& sonar) {
  if (!params.map.enabled) return 1;
  const double scans =
      std::ceil(params.sure_age * unit_of_time(sonar) / sonar.scan_period) + params.judge_every;
  return static_cast<int>(std::min<double>(scans, kMostScans));
}

SensorModelParams model_of(const core::SonarParams& sonar) {
  SensorModelParams model;
  model.clutter = clutter_model_of(sonar);
  return model;
}

}  // namespace

void validate(const LocalClutterParams& params) {
  validate(params.spill);
  validate(params.map);
  core::require(params.judge_every >= 1, "judge_every must be >= 1", params.judge_every);
  core::require_positive("sure_age", params.sure_age);
  core::require_positive("sure_sigma", params.sure_sigma);
  core::require_positive("sure_sigmas", params.sure_sigmas);
  core::require_positive("creep", params.creep);
  core::require_positive("enough_nats", params.enough_nats);
  core::require(params.clear > 0.0 && params.clear < 1.0, "clear must be in (0, 1)", params.clear);
}

LocalClutter::LocalClutter(const LocalClutterParams& params, const core::SonarParams& sonar)
    : params_((validate(params), params)),
      sonar_(sonar),
      scans_(figures_of(sonar), model_of(sonar), scans_kept(params, sonar)),
      kept_(static_cast<std::size_t>(scans_.capacity())) {}

void LocalClutter::take(const core::PosedScan& scan) {
  if (!params_.map.enabled) {
    scan_to_detections(scan, 0, detections_);
    worth_.assign(detections_.size(), {});
    return;
  }
  newest_ = number_of(scan.scan.sensor_id);
  scans_.push(scan, static_cast<int>(newest_));
  price_newest();
  choose_echoes();
  weigh();
}

std::size_t LocalClutter::number_of(std::int32_t sensor_id) {
  const auto known =
      std::find_if(sensors_.begin(), sensors_.end(), [&](const Sensor& s) { return s.id == sensor_id; });
  if (known == sensors_.end()) {
    sensors_.push_back({sensor_id, ClutterMap(params_.map, sonar_), SpillModel(params_.spill)});
    sensors_.back().rate = kUnknownFalseAlarm * sonar_.num_beams;
    return sensors_.size() - 1;
  }
  return static_cast<std::size_t>(known - sensors_.begin());
}

LocalClutter::Kept& LocalClutter::kept_at(int age) {
  return kept_[static_cast<std::size_t>((scans_.pushed() - 1 - age) % scans_.capacity())];
}

const LocalClutter::Kept& LocalClutter::kept_at(int age) const {
  return kept_[static_cast<std::size_t>((scans_.pushed() - 1 - age) % scans_.capacity())];
}

void LocalClutter::price_newest() {
  Sensor& sensor = sensors_[newest_];
  const ScanTable& newest = scans_.newest();
  const auto group = [&] { scans_.group(0, sensor.spill, background_); };
  const double false_alarm = std::min(1.0, sensor.rate / newest.num_beams);
  if (price_echoes(newest, {sensor.rate, false_alarm}, sensor.map, sensor.spill, group, background_)) group();
}

// Keeps of the newest scan's returns those that lead the group of one echo, or are in none.
void LocalClutter::choose_echoes() {
  const ScanTable& newest = scans_.newest();
  Kept& kept = kept_at(0);
  kept.index.clear();
  detections_.clear();
  for (std::size_t j = 0; j < newest.detections.size(); ++j) {
    const auto slot = slot_of(newest, j);
    if (slot && !leads_group(newest, *slot)) continue;
    kept.index.push_back(j);
    detections_.push_back(newest.detections[j]);
    detections_.back().p_earth = seen_place(newest, newest.detections[j]).p_earth;
  }
  kept.taker.assign(kept.index.size(), {});
  kept.background.assign(kept.index.size(), 1.0);
  kept.counted.assign(kept.index.size(), 1.0);
  read_background(0);
}

// Takes what `background_` says of the returns that are kept of the scan that was just priced, and asks for
// those behind another return of their beam.
void LocalClutter::read_background(int age) {
  const ScanTable& scan = scans_.at_age(age);
  const Sensor& sensor = sensors_[newest_];
  Kept& kept = kept_at(age);
  for (std::size_t k = 0; k < kept.index.size(); ++k) {
    const auto slot = slot_of(scan, kept.index[k]);
    kept.background[k] = slot ? static_cast<double>(background_[*slot])
                              : sensor.map.background_of(scan, kept.index[k], sensor.rate);
    const double beyond_clear = kept.background[k] / params_.clear;
    kept.counted[k] = std::min(1.0, std::max(kept.background[k], beyond_clear * beyond_clear));
  }
}

bool LocalClutter::leads_group(const ScanTable& scan, std::size_t slot) const {
  if (scan.clutter == ClutterModel::point || scan.group[slot] < 0) return true;
  for (std::size_t other = 0; other < scan.group.size(); ++other) {
    if (scan.group[other] != scan.group[slot] || other == slot) continue;
    if (scan.share[other] > scan.share[slot] || (scan.share[other] == scan.share[slot] && other < slot))
      return false;
  }
  return true;
}

// Mean ln of the likelihood ratio of a target's own return in the background, its prediction being as
// uncertain as the return: N(z) / c.
double LocalClutter::information() const {
  const ScanTable& newest = scans_.newest();
  const double density = sensors_[newest_].rate / (newest.sector() * newest.max_range);
  const double volume = 4.0 * std::numbers::pi * sonar_.range_sigma * sonar_.bearing_sigma_or_default();
  return -std::log(volume * density) - 1.0;
}

// Gates and counts of hits were set in uniform clutter: only what is denser than `clear` takes from them, and
// only where a return does not tell enough anyhow.
void LocalClutter::weigh() {
  const double clear = information() + std::log(params_.clear);
  const double full = std::max(kLeastInformation, std::min(clear, params_.enough_nats));
  const Kept& kept = kept_at(0);
  worth_.clear();
  for (std::size_t k = 0; k < kept.index.size(); ++k) {
    const double there = clear + std::log(kept.background[k] / params_.clear);
    const double loss = std::max(0.0, std::min(clear, full) - there);
    worth_.push_back({kept.counted[k], std::max(0.0, 1.0 - loss / full), 2.0 * loss});
  }
}

std::span<const double> LocalClutter::backgrounds(int age) const {
  if (!params_.map.enabled || age >= scans_.size()) return {};
  return kept_at(age).counted;
}

void LocalClutter::learn(std::span<const Taker> takers) {
  if (!params_.map.enabled) return;
  Sensor& sensor = sensors_[newest_];
  kept_at(0).taker.assign(takers.begin(), takers.end());
  own_.assign(scans_.newest().detections.size(), 0.0);
  for (std::size_t k = 0; k < takers.size(); ++k)
    if (takers[k].confirmed) own_echo(0, k);
  sensor.map.learn(scans_.newest(), own_, sensor.rate);
  sensor.map.add(scans_.newest());
  if (++sensor.scans % params_.judge_every == 0) {
    discount_movers();
    for (int age = 0; age < scans_.size(); ++age)
      if (of_newest_sensor(age)) price(age);
  }
  sensor.rate = rate_of_background();
}

// Marks one of the returns that are kept of a scan as a target's, and with it all of its echo.
void LocalClutter::own_echo(int age, std::size_t k) {
  const ScanTable& scan = scans_.at_age(age);
  own_[kept_at(age).index[k]] = 1.0;
  const auto slot = slot_of(scan, kept_at(age).index[k]);
  if (!slot || scan.clutter == ClutterModel::point || scan.group[*slot] < 0) return;
  for (std::size_t j = 0; j < scan.detections.size(); ++j)
    if (const auto other = slot_of(scan, j); other && scan.group[*other] == scan.group[*slot]) own_[j] = 1.0;
}

// Judges a scan that is kept anew.
void LocalClutter::price(int age) {
  const ScanTable& scan = scans_.at_age(age);
  background_.assign(scan.background.size(), 1.0F);
  sensors_[newest_].map.price(scan, sensors_[newest_].rate, background_);
  read_background(age);
}

void LocalClutter::discount_movers() {
  find_movers();
  if (movers_.empty()) return;
  for (int age = 0; age < scans_.size(); ++age) {
    if (!of_newest_sensor(age)) continue;
    const Kept& kept = kept_at(age);
    own_.assign(scans_.at_age(age).detections.size(), 0.0);
    for (std::size_t k = 0; k < kept.index.size(); ++k)
      if (std::find(movers_.begin(), movers_.end(), kept.taker[k].track) != movers_.end()) own_echo(age, k);
    sensors_[newest_].map.discount(scans_.at_age(age), own_, sensors_[newest_].rate);
  }
}

// Tracks that took a return of the newest scans and surely move, by what they took.
void LocalClutter::find_movers() {
  courses_.clear();
  for (int age = scans_.size() - 1; age >= 0; --age) {
    const Kept& kept = kept_at(age);
    for (std::size_t k = 0; k < kept.index.size(); ++k)
      if (kept.taker[k].track != 0)
        add_to_course(kept.taker[k], scans_.at_age(age).detections[kept.index[k]],
                      scans_.seconds_at_age(age));
  }
  movers_.clear();
  for (const Course& course : courses_)
    if (surely_moves(course)) movers_.push_back(course.track);
}

void LocalClutter::add_to_course(const Taker& taker, const core::Detection& detection, double time) {
  auto course =
      std::find_if(courses_.begin(), courses_.end(), [&](const Course& c) { return c.track == taker.track; });
  if (course == courses_.end()) {
    courses_.emplace_back();
    course = courses_.end() - 1;
    course->track = taker.track;
    course->first = time;
  }
  course->last = time;
  course->n += 1.0;
  course->time += time;
  course->times += time * time;
  course->place += detection.p_earth;
  course->products += time * detection.p_earth;
}

// Least squares of a straight course, each return with the range error.
bool LocalClutter::surely_moves(const Course& c) const {
  if (c.last - c.first < params_.sure_age * unit_of_time(sonar_)) return false;
  const double spread = c.times - c.time * c.time / c.n;
  if (spread <= 0.0) return false;
  const Eigen::Vector2d velocity = (c.products - c.time / c.n * c.place) / spread;
  const double variance = sonar_.range_sigma * sonar_.range_sigma / spread;
  const double most = params_.sure_sigma * sonar_.max_speed, creep = params_.creep * sonar_.max_speed;
  return variance < most * most &&
         velocity.norm() > params_.sure_sigmas * std::sqrt(variance + creep * creep);
}

// P_F by the scans that are kept, each return counted by the background's share of it.
double LocalClutter::rate_of_background() const {
  const bool point = scans_.newest().clutter == ClutterModel::point;
  double returns = kUnknownFalseAlarm * kUnknownBeams, beams = kUnknownBeams;
  if (point) returns = kUnknownFalseAlarm * sonar_.num_beams, beams = 1.0;
  for (int age = 0; age < scans_.size(); ++age) {
    if (!of_newest_sensor(age)) continue;
    const Kept& kept = kept_at(age);
    beams += point ? 1.0 : scans_.at_age(age).num_beams;
    for (std::size_t k = 0; k < kept.index.size(); ++k)
      if (!kept.taker[k].confirmed) returns += kept.background[k];
  }
  const double rate = returns / beams * (point ? 1.0 : scans_.newest().num_beams);
  return sensors_[newest_].map.at_least_typical(rate);
}

std::optional<core::ClutterGrid> LocalClutter::grid() const {
  if (!params_.map.enabled || scans_.size() == 0) return std::nullopt;
  return clutter_grid(sensors_[newest_].map, scans_.newest(), sensors_[newest_].rate);
}

}  // namespace lookout::csht
