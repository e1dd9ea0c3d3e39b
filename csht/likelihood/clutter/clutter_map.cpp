#include "csht/likelihood/clutter/clutter_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "csht/likelihood/sensor_units.hpp"

namespace lookout::csht {
namespace {

constexpr double kMicroseconds = 1e6;
// Background's share around a return from which on a track is believed to have made it.
constexpr double kClear = 0.5;
constexpr float kListened = 0.5F;

// The background's share where the density is larger by `excess` than `base`. @param rate of the background
// by the learnt P_F, @param base by what most of the fan returns at most.
float background_share(double rate, double base, double excess) {
  return static_cast<float>(std::min(1.0, rate / (base * (1.0 + excess))));
}

// Share of the returns that an excess of density brings.
double share_of(double excess) {
  return excess / (1.0 + excess);
}

std::int64_t microseconds(double seconds) {
  return static_cast<std::int64_t>(seconds * kMicroseconds);
}

// Beside the looks that judge a scan there is room for those that are too near to it in time.
LookMemory::Limits limits_of(const ClutterMapParams& params, const core::SonarParams& sonar,
                             std::int64_t leave_out_us) {
  LookMemory::Limits limits;
  limits.range_reach = params.range_reach * sonar.range_sigma;
  limits.spacing_us = microseconds(params.memory_time * unit_of_time(sonar) / params.memory_looks);
  limits.most_returns = static_cast<std::size_t>(params.most_returns);
  const std::int64_t waiting = std::min<std::int64_t>(
      params.memory_looks, leave_out_us / std::max<std::int64_t>(1, limits.spacing_us));
  if (params.enabled) limits.most_looks = static_cast<std::size_t>(params.memory_looks + waiting);
  return limits;
}

}  // namespace

ClutterMap::ClutterMap(const ClutterMapParams& params, const core::SonarParams& sonar)
    : params_(params),
      range_reach_(params.range_reach * sonar.range_sigma),
      leave_out_us_(microseconds(sensor_seconds(params.leave_out_time, params.leave_out_scans, sonar))),
      memory_(limits_of(params, sonar, leave_out_us_)),
      times_(leave_out_us_,
             static_cast<std::int64_t>(params.spot_times * static_cast<double>(leave_out_us_))),
      sonar_({params.sonar_beams, range_reach_}),
      earth_({params.earth_beams, range_reach_}),
      sonar_dense_(params.sonar_learning, params.sonar_prior.share),
      earth_dense_(params.earth_learning, params.standing_share) {
  times_.reserve(memory_.most_looks());
}

// A scan that was more probably lost on its way than heard is no look: its empty places tell nothing.
void ClutterMap::add(const ScanTable& scan) {
  if (scan.listened >= kListened && memory_.add(scan)) find_typical_rate(scan);
}

void ClutterMap::find_typical_rate(const ScanTable& scan) {
  typical_.begin(scan.num_beams);
  for (const Look& look : memory_.looks())
    for (const BinnedPoint& p : look.in_sonar)
      typical_.take(static_cast<double>(p.x) / scan.num_beams + 0.5,
                    static_cast<double>(p.y) * range_reach_ / scan.max_range, p.weight);
  typical_.end(static_cast<double>(memory_.looks().size()));
}

void ClutterMap::discount(const ScanTable& scan, std::span<const double> own, double rate) {
  rate = typical_.at_most(rate);
  Look* look = memory_.look_at(scan);
  if (look == nullptr || look->earth.size() != own.size()) return;
  times_.mark(memory_, scan.utime);
  for (std::size_t j = 0; j < own.size(); ++j) {
    if (own[j] <= 0.0) continue;
    if (clear_around(scan, seen_place(scan, scan.detections[j]), rate) < kClear) continue;
    const auto rest = static_cast<float>(1.0 - std::min(own[j], 1.0));
    // What a track took once stays taken, even if that track ends.
    look->earth[j].weight = look->in_sonar[j].weight = std::min(look->earth[j].weight, rest);
  }
}

void ClutterMap::price(const ScanTable& scan, double rate, std::vector<float>& background) {
  background.assign(background.size(), 1.0F);
  times_.mark(memory_, scan.utime);
  if (memory_.looks().empty()) return;
  Look* look = memory_.look_at(scan);
  const double base = typical_.at_most(rate);
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const std::optional<std::size_t> slot = slot_of(scan, j);
    if (!slot) continue;
    const PlaceExcess found = excess_at(scan, seen_place(scan, scan.detections[j]), base);
    background[*slot] = background_share(rate, base, found.density());
    if (look == nullptr) continue;
    look->earth[j].free = static_cast<float>(1.0 - found.explained_by_sonar());
    look->in_sonar[j].free = static_cast<float>(1.0 - found.explained_by_earth());
  }
  if (!scan.whole_circle || scan.clutter == ClutterModel::point) return;
  background[0] = background[static_cast<std::size_t>(scan.num_beams)];
  background[static_cast<std::size_t>(scan.num_beams) + 1] = background[1];
}

std::vector<ClutterMap::PricedPlace> ClutterMap::places(const ScanTable& scan, double rate,
                                                        std::size_t most) const {
  std::size_t returns = 0, k = 0;
  for (const Look& look : memory_.looks()) returns += look.earth.size();
  const std::size_t stride = returns / (most + 1) + 1;
  std::vector<PricedPlace> places;
  ScanTable then = scan;  // The same place of the sonar, at the time of each look: it must not judge itself.
  const auto take = [&](const SeenPlace& place) {
    if (place.range < scan.max_range && 2.0 * std::abs(place.beam) < scan.num_beams)
      places.push_back({place.beam, place.range, background_at(then, place, rate)});
  };
  for (const Look& look : memory_.looks()) {
    then.utime = look.utime;
    times_.mark(memory_, then.utime);
    for (std::size_t j = 0; j < look.earth.size(); ++j) {
      if (k++ % stride != 0) continue;
      take(memory_.place_around(scan, look.in_sonar[j]));
      take(seen_place(scan, Eigen::Vector2d{look.earth[j].x, look.earth[j].y}));
    }
  }
  return places;
}

double ClutterMap::background_at(const ScanTable& scan, const SeenPlace& place, double rate) const {
  const double base = typical_.at_most(rate);
  return static_cast<double>(background_share(rate, base, excess_at(scan, place, base).density()));
}

ClutterMap::PlaceExcess ClutterMap::excess_at(const ScanTable& scan, const SeenPlace& place,
                                              double rate) const {
  return {sonar_.at(scan, place, memory_, times_, rate, sonar_prior()).place,
          earth_.at(scan, place, memory_, times_, rate, earth_prior())};
}

// What moves with the sonar shows, blurred, in the earth's frame, and what stands in the sonar's: returns
// that the other frame explains count as far as it is dense at this place too.
double ClutterMap::PlaceExcess::density() const {
  const double stands =
      earth.free.density() + share_of(sonar.all.density()) * (earth.all.density() - earth.free.density());
  const double moves =
      sonar.free.density() + share_of(earth.free.density()) * (sonar.all.density() - sonar.free.density());
  return std::max(stands, moves);
}

double ClutterMap::PlaceExcess::explained_by_sonar() const {
  return sonar.all.density() / (1.0 + sonar.all.density() + earth.free.density());
}

double ClutterMap::PlaceExcess::explained_by_earth() const {
  return earth.free.density() / (1.0 + sonar.free.density() + earth.free.density());
}

ExcessPrior ClutterMap::sonar_prior() const {
  return {std::clamp(sonar_dense_.share(), params_.sonar_prior.share, params_.most_dense),
          params_.sonar_prior.shape, std::max(params_.sonar_prior.mean, sonar_dense_.mean_rate())};
}

ExcessPrior ClutterMap::earth_prior() const {
  return {std::min(params_.most_share, params_.least_share + params_.share_growth * earth_dense_.share()),
          params_.earth_shape, earth_dense_.mean_rate()};
}

// The background's share of the returns in a frame around a place, in the sonar's frame or the earth's,
// whichever is less: its middle, where a target's own returns are, is left out.
double ClutterMap::clear_around(const ScanTable& scan, const SeenPlace& place, double rate) const {
  if (times_.counted() == 0.0) return 1.0;
  const double y = place.range / range_reach_;
  double sonar = 0.0, earth = 0.0;
  const auto in_frame = [](double across, double along) {
    const double a = std::abs(across), b = std::abs(along);
    return a <= FrameCounts::kBeams && b <= FrameCounts::kReaches &&
           !(a <= FrameCounts::kMiddleBeams && b <= FrameCounts::kMiddleReaches);
  };
  const PointBins& bins = memory_.in_sonar();
  bins.visit(place.beam, y, FrameCounts::kBeams, FrameCounts::kReaches, [&](const BinnedPoint& p) {
    if (times_.of(p).counted > 0.0F &&
        in_frame(static_cast<double>(p.x) - place.beam, static_cast<double>(p.y) - y))
      sonar += static_cast<double>(p.weight);
  });
  const Eigen::Vector2d along =
      (place.p_earth - Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east)).normalized();
  const double beam = scan.width_at(place.beam) * place.range;
  const double box = std::hypot(FrameCounts::kBeams * beam, FrameCounts::kReaches * range_reach_);
  memory_.earth().visit(place.p_earth.x(), place.p_earth.y(), box, box, [&](const BinnedPoint& p) {
    if (times_.of(p).counted == 0.0F) return;
    const double dn = static_cast<double>(p.x) - place.p_earth.x();
    const double de = static_cast<double>(p.y) - place.p_earth.y();
    if (in_frame((de * along.x() - dn * along.y()) / beam, (dn * along.x() + de * along.y()) / range_reach_))
      earth += static_cast<double>(p.weight);
  });
  const double area = 4.0 * (FrameCounts::kBeams * FrameCounts::kReaches -
                             FrameCounts::kMiddleBeams * FrameCounts::kMiddleReaches);
  const double expected = times_.counted() * area * rate / scan.num_beams * range_reach_ / scan.max_range;
  return 1.0 / (1.0 + std::max(excess(sonar, expected, params_.sonar_prior).density(),
                               excess(earth, expected, params_.sonar_prior).density()));
}

// What moves with the sonar shows, blurred, in the earth's frame too: only what is denser there stands.
void ClutterMap::learn(const ScanTable& newest, std::span<const double> own, double rate) {
  rate = typical_.at_most(rate);
  times_.mark(memory_, newest.utime);
  sonar_dense_.begin_scan();
  if (times_.counted() > 0.0) earth_dense_.begin_scan();
  for (std::size_t j = 0; j < newest.detections.size(); ++j) {
    const SeenPlace place = seen_place(newest, newest.detections[j]);
    const Excess sonar = sonar_.at(newest, place, memory_, times_, rate, sonar_prior()).clear.all;
    sonar_dense_.take(1.0 - own[j], sonar.density() > 0.0 ? sonar.probability : 0.0, sonar.rate);
    if (times_.counted() == 0.0) continue;
    const double stands = earth_.at(newest, place, memory_, times_, rate, earth_prior()).all.density();
    const bool denser = stands > sonar.density();
    earth_dense_.take(1.0, denser ? stands / (1.0 + stands) : 0.0, 1.0 + stands);
  }
}

}  // namespace lookout::csht
