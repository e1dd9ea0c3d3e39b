#include "csht/joint/clutter_learning.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "csht/joint/density/lived_odds.hpp"
#include "csht/likelihood/clutter/clutter_grid.hpp"
#include "csht/likelihood/clutter/echo_prices.hpp"
#include "csht/likelihood/sensor_units.hpp"

namespace lookout::csht {
namespace {

constexpr double kLikely = 0.5;  // Existence of a track whose returns are taken for a target's.

double background_rate(const ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  const SensorFigures& figures = scans.figures();
  return scans.newest().clutter == ClutterModel::point
             ? figures.clutter_per_scan
             : figures.false_alarm_probability * scans.newest().num_beams;
}

// ln of the volume that a Gaussian of a track's covariance fills [m^2 (m/s)^2]; finite for a single point
// too.
double log_volume(const CloudMoments& moments) {
  const double determinant = moments.covariance.topLeftCorner<4, 4>().determinant();
  return 0.5 * std::log(std::max(determinant, std::numeric_limits<double>::min())) +
         2.0 * std::log(2.0 * std::numbers::pi);
}

// Whether a scan of that age is priced anew: four times after `every` scans, then whenever its age has
// doubled, for the more scans judge a place the less one more changes.
bool is_due(int age, int every) {
  int due = 4 * every;
  if (age <= due) return age % every == 0;
  while (due < age) due *= 2;
  return due == age;
}

}  // namespace

ClutterLearning::ClutterLearning(const ClutterLearningParams& params, const core::SonarParams& sonar)
    : params_(params),
      sonar_(sonar),
      sure_age_s_(params.sure_age * unit_of_time(sonar)),
      max_speed_(sonar.max_speed) {
  sensors_.push_back(blank_sensor());
}

ClutterLearning::Sensor ClutterLearning::blank_sensor() const {
  return {ClutterMap(params_.map, sonar_), SpillModel(params_.spill), IntensityLaw(params_.intensity),
          BurstScans()};
}

// What was learnt of the sonar that made this scan, the newest.
ClutterLearning::Sensor& ClutterLearning::sensor_of(const ScanTable& newest) {
  newest_ = static_cast<std::size_t>(newest.sensor);
  while (sensors_.size() <= newest_) sensors_.push_back(blank_sensor());
  return sensors_[newest_];
}

void ClutterLearning::price_newest(ScanLikelihood& likelihood) {
  if (!params_.map.enabled) return;
  const ScanTable& newest = likelihood.scans().newest();
  Sensor& sensor = sensor_of(newest);
  if (prices_.empty()) reserve(newest, likelihood.scans().capacity());
  const double rate = background_rate(likelihood);
  Prices& prices = prices_of(0, likelihood.scans());
  std::vector<float>& background = prices.background;
  const auto group_newest = [&] { likelihood.group(0, sensor.spill, background); };
  const double false_alarm = likelihood.scans().figures().false_alarm_probability;
  if (price_echoes(newest, {rate, false_alarm}, sensor.map, sensor.spill, group_newest, background))
    group(0, likelihood);
  likelihood.set_background(0, background);
  if (const Burst burst = sensor.bursts.take(background_returns(newest, background), rate);
      burst.excess > 0.0)
    likelihood.set_burst(burst);
  sensor.intensity.rate(newest, background, prices.loudness);
  if (sensor.intensity.known()) likelihood.set_loudness(0, prices.loudness);
}

// Returns that one echo may have made count once.
void ClutterLearning::group(int age, ScanLikelihood& likelihood) {
  std::vector<float>& background = prices_of(age, likelihood.scans()).background;
  likelihood.group(age, sensors_[newest_].spill, background);
  const ScanTable& scan = likelihood.scans().at_age(age);
  if (scan.clutter == ClutterModel::point) return;
  for (std::size_t slot = 0; slot < scan.share.size(); ++slot) background[slot] *= scan.share[slot];
}

std::optional<core::ClutterGrid> ClutterLearning::grid(const ScanLikelihood& likelihood) const {
  if (!params_.map.enabled || likelihood.scans().size() == 0) return std::nullopt;
  const ScanTable& newest = likelihood.scans().newest();
  const ClutterMap& map = sensors_[newest_].map;
  return clutter_grid(map, newest, map.at_least_typical(background_rate(likelihood)));
}

void ClutterLearning::reserve(const ScanTable& scan, int scans) {
  const std::vector<float> none(scan.background.size());
  prices_.assign(static_cast<std::size_t>(scans), {none, none});
  changed_.reserve(static_cast<std::size_t>(scans));
  own_.reserve(static_cast<std::size_t>(params_.map.most_returns));
  likely_.reserve(own_.capacity());
}

void ClutterLearning::learn(std::span<TargetTrack> tracks, ScanLikelihood& likelihood,
                            const std::function<bool()>& stopped) {
  if (!params_.map.enabled) return;
  const ScanHistory& scans = likelihood.scans();
  mark(tracks, [](const TargetTrack& track) { return track.existence() > kLikely; });
  own_returns(0, likelihood);
  Sensor& sensor = sensor_of(scans.newest());
  sensor.map.learn(scans.newest(), own_, background_rate(likelihood));
  sensor.map.add(scans.newest());
  learn_intensities(tracks, likelihood);
  ++sensor.scans;
  price_anew(likelihood);
  if (sensor.scans % params_.judge_every != 0) return;
  discount_movers(tracks, likelihood);
  judge_anew(tracks, likelihood, stopped);
}

// After `own_returns` of the newest scan by all likely tracks.
void ClutterLearning::learn_intensities(std::span<const TargetTrack> tracks,
                                        const ScanLikelihood& likelihood) {
  const ScanTable& newest = likelihood.scans().newest();
  if (!params_.intensity.enabled) return;
  if (!mark(tracks, [&](const TargetTrack& track) { return is_no_clutter(track, newest.utime); })) return;
  likely_.swap(own_);
  own_returns(0, likelihood);
  sensors_[newest_].intensity.take(newest, own_, likely_);
}

// Marks the tracks that `holds` is true of. @return whether there is one.
template <class Condition>
bool ClutterLearning::mark(std::span<const TargetTrack> tracks, const Condition& holds) {
  marked_.assign(tracks.size(), 0);
  for (std::size_t k = 0; k < tracks.size(); ++k) marked_[k] = tracks[k].used && holds(tracks[k]) ? 1 : 0;
  return std::find(marked_.begin(), marked_.end(), 1) != marked_.end();
}

void ClutterLearning::discount_movers(std::span<const TargetTrack> tracks, const ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  const std::int64_t now = scans.newest().utime;
  if (!mark(tracks, [&](const TargetTrack& track) { return is_no_clutter(track, now); })) return;
  for (int age = 0; age < scans.size(); ++age) {
    if (scans.at_age(age).sensor != scans.newest().sensor) continue;
    own_returns(age, likelihood);
    sensors_[newest_].map.discount(scans.at_age(age), own_, background_rate(likelihood));
  }
}

// Probabilities that the returns of a scan are of the tracks that are marked.
void ClutterLearning::own_returns(int age, const ScanLikelihood& likelihood) {
  const ScanTable& scan = likelihood.scans().at_age(age);
  own_.clear();
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const core::Detection& detection = scan.detections[j];
    const bool point = scan.clutter == ClutterModel::point;
    own_.push_back(
        likelihood.explained(age, point ? static_cast<int>(j) : detection.beam, detection.range, marked_));
  }
}

bool ClutterLearning::is_no_clutter(const TargetTrack& track, std::int64_t now) const {
  if (track.existence() < params_.sure_existence) return false;
  if (core::seconds(now - track.first_utime) < sure_age_s_) return false;
  const double sigma = std::sqrt(0.5 * (track.moments.covariance(2, 2) + track.moments.covariance(3, 3)));
  return sigma < params_.sure_sigma * max_speed_ && surely_moves(track.moments, params_.mover, max_speed_);
}

void ClutterLearning::judge_anew(std::span<TargetTrack> tracks, ScanLikelihood& likelihood,
                                 const std::function<bool()>& stopped) {
  find_changes(likelihood.scans());
  if (changed_.empty()) return;
  gains_.resize(std::max(gains_.size(), tracks.size()));
  const ScanHistory& scans = likelihood.scans();
  survival_.assign(static_cast<std::size_t>(scans.size()), 1.0);
  for (int age = 0; age + 1 < scans.size(); ++age)
    survival_[static_cast<std::size_t>(age)] =
        std::exp((scans.seconds_at_age(age + 1) - scans.seconds_at_age(age)) / mean_life_s_);
  for (const bool after : {false, true}) {
    for (std::size_t slot = 0; slot < tracks.size(); ++slot) {
      if (stopped()) return;
      if (tracks[slot].used) add_gains(after, tracks[slot], static_cast<int>(slot), likelihood);
    }
    if (after) break;
    for (const int age : changed_) {
      const Prices& prices = prices_of(age, likelihood.scans());
      likelihood.set_background(age, prices.background);
      likelihood.set_loudness(age, prices.loudness);
    }
  }
  for (std::size_t slot = 0; slot < tracks.size(); ++slot)
    if (tracks[slot].used) take_change(static_cast<int>(slot), tracks[slot]);
}

ClutterLearning::Prices& ClutterLearning::prices_of(int age, const ScanHistory& scans) {
  return prices_[static_cast<std::size_t>(scans.pushed() - 1 - age) % prices_.size()];
}

// Finds the new prices of those scans in memory that are due, a few at each scan.
void ClutterLearning::price_anew(ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  const double rate = background_rate(likelihood);
  const Sensor& sensor = sensors_[newest_];
  for (int age = 1; age < scans.size(); ++age) {
    const ScanTable& scan = scans.at_age(age);
    if (scan.sensor != scans.newest().sensor || !is_due(age, params_.judge_every)) continue;
    Prices& prices = prices_of(age, scans);
    prices.background.resize(scan.background.size());
    sensors_[newest_].map.price(scan, rate, prices.background);
    group(age, likelihood);
    sensor.intensity.rate(scan, prices.background, prices.loudness);
  }
}

// Notes the ages whose prices differ from those that hold.
void ClutterLearning::find_changes(const ScanHistory& scans) {
  const auto same = [&](float one, float other) {
    return std::abs(one - other) <= static_cast<float>(params_.least_change) * other;
  };
  changed_.clear();
  for (int age = 0; age < scans.size(); ++age) {
    const ScanTable& scan = scans.at_age(age);
    if (scan.sensor != scans.newest().sensor) continue;
    const Prices& now = prices_of(age, scans);
    if (!std::equal(now.background.begin(), now.background.end(), scan.background.begin(), same) ||
        !std::equal(now.loudness.begin(), now.loudness.end(), scan.loudness.begin(), same))
      changed_.push_back(age);
  }
}

// Adds what a track gained by each scan of its life, under the prices that hold: its trajectories' mean. What
// they gain anew less what they gained goes to `log_ratio`.
void ClutterLearning::add_gains(bool anew, TargetTrack& track, int slot, ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  const auto life = static_cast<int>(std::min<std::int64_t>(scans.pushed() - track.first_scan, scans.size()));
  std::vector<double>& gain = gains_[static_cast<std::size_t>(slot)][anew ? 1 : 0];
  if (anew)
    gain = gains_[static_cast<std::size_t>(slot)][0];
  else
    track.log_ratio.assign(track.cloud.size(), 0.0);
  gain.resize(static_cast<std::size_t>(std::max(life, 0)));
  for (int age = 0; age < life; ++age) {
    const bool changed = std::binary_search(changed_.begin(), changed_.end(), age);
    if (anew && !changed) continue;
    ratio_.assign(track.cloud.size(), 0.0);
    likelihood.add(track.cloud, track.moments.mean, {age, age, false}, slot, ratio_);
    gain[static_cast<std::size_t>(age)] =
        std::inner_product(ratio_.begin(), ratio_.end(), track.cloud.weight.begin(), 0.0);
    if (!changed) continue;
    for (std::size_t i = 0; i < ratio_.size(); ++i) track.log_ratio[i] += anew ? ratio_[i] : -ratio_[i];
  }
}

// The evidence before and anew makes odds of a whole life each; their difference is what changes. Before its
// first scan a target has the odds of the prior in the volume that its density fills now (Laplace's method).
void ClutterLearning::take_change(int slot, TargetTrack& track) const {
  const auto& [before, after] = gains_[static_cast<std::size_t>(slot)];
  const double first = track.log_density + log_volume(track.moments);
  track.log_odds += lived_odds(first, after, survival_) - lived_odds(first, before, survival_);
  track.cloud.reweigh(track.log_ratio);
  track.moments = track.cloud.moments();
}

}  // namespace lookout::csht
