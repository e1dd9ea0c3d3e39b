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
// A kernel's counts are no Poisson numbers: divided by this, the mean of its squares over its mean, their
// variance equals their mean. Of a triangle it is 2/3, of a product of two 4/9.
constexpr double kTriangle = 2.0 / 3.0;
// Standing things are often sharper than the sonar's error: the earth's kernel has finer ones in it.
constexpr double kFine = 1.0 / 3.0;
// From so many returns on they may lie on a line, which is as steep as this at most, in metres down for one
// across.
constexpr double kLine = 3.0, kSteepest = 6.0;
constexpr double kLines = 0.5;  // Share of what stands that is a line.
constexpr float kListened = 0.5F;

// A triangle of height 1 and half width 1.
double triangle(double x) {
  return std::max(0.0, 1.0 - std::abs(x));
}

// Its integral from -inf to x.
double triangle_below(double x) {
  const double c = std::clamp(x, -1.0, 1.0);
  return c < 0.0 ? 0.5 * (1.0 + c) * (1.0 + c) : 1.0 - 0.5 * (1.0 - c) * (1.0 - c);
}

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
      spot_us_(static_cast<std::int64_t>(params.spot_times * static_cast<double>(leave_out_us_))),
      memory_(limits_of(params, sonar, leave_out_us_)),
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
  mark_looks(scan);
  for (std::size_t j = 0; j < own.size(); ++j) {
    if (own[j] <= 0.0) continue;
    if (clear_around(scan, seen_place(scan, scan.detections[j]), rate) < kClear) continue;
    const auto rest = static_cast<float>(1.0 - std::min(own[j], 1.0));
    // What a track took once stays taken, even if that track ends.
    look->earth[j].weight = look->in_sonar[j].weight = std::min(look->earth[j].weight, rest);
  }
}

void ClutterMap::mark_looks(const ScanTable& scan) const {
  times_.clear();
  num_counted_ = num_far_ = num_others_ = 0.0;
  for (const Look& look : memory_.looks()) {
    const std::int64_t lag = std::abs(look.utime - scan.utime);
    LookTime time;
    time.own = look.utime == scan.utime;
    time.before = look.utime < scan.utime;
    time.counted = lag > leave_out_us_;
    time.far = lag > spot_us_;
    times_.push_back(time);
    num_counted_ += time.counted ? 1.0 : 0.0;
    num_far_ += time.far ? 1.0 : 0.0;
    num_others_ += time.own ? 0.0 : 1.0;
  }
}

void ClutterMap::price(const ScanTable& scan, double rate, std::vector<float>& background) {
  background.assign(background.size(), 1.0F);
  mark_looks(scan);
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
    mark_looks(then);
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
  const TwoExcesses spot = spot_excess(scan, place, rate, true),
                    frame = frame_excess(scan, place, rate, true);
  return {{denser(spot.all, frame.all), denser(spot.free, frame.free)}, earth_excess(scan, place, rate)};
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

void ClutterMap::TwoCounts::take(const BinnedPoint& point, double kernel) {
  const double count = static_cast<double>(point.weight) * kernel;
  all += count;
  free += static_cast<double>(point.free) * count;
}

// What lies around a place in all scans but its own: it needs no past, and a target that moves along with the
// sonar does not price its own returns.
ClutterMap::TwoExcesses ClutterMap::frame_excess(const ScanTable& scan, const SeenPlace& place, double rate,
                                                 bool corners) const {
  FrameCounts all, free;
  const double y = place.range / range_reach_;
  memory_.in_sonar().visit(
      place.beam, y, FrameCounts::kBeams, FrameCounts::kReaches, [&](const BinnedPoint& p) {
        const LookTime& time = time_of(p);
        const FrameCounts::Spot spot =
            FrameCounts::spot_of(static_cast<double>(p.x) - place.beam, static_cast<double>(p.y) - y);
        if (time.own || !spot.counts) return;
        all.take(spot, static_cast<double>(p.weight), time.before);
        free.take(spot, static_cast<double>(p.weight * p.free), time.before);
      });
  const double per_area = num_others_ * rate / scan.num_beams * range_reach_ / scan.max_range;
  const FrameCounts::Border border =
      FrameCounts::border_at(scan, place.beam, y, scan.max_range / range_reach_);
  const FrameExcess of_all(all, border, per_area, sonar_prior()),
      of_free(free, border, per_area, sonar_prior());
  if (!corners || !(of_all.is_corner() || of_free.is_corner())) return {of_all.both(), of_free.both()};
  const TwoExcesses spot = spot_excess(scan, place, rate, false);
  return {of_all.with_corner(spot.all), of_free.with_corner(spot.free)};
}

// What lies at a place, but long before or after: a target that moves along with the sonar is found by then.
ClutterMap::TwoExcesses ClutterMap::spot_excess(const ScanTable& scan, const SeenPlace& place, double rate,
                                                bool far) const {
  const double looks = far ? num_far_ : num_counted_;
  if (looks == 0.0) return {};
  const double y = place.range / range_reach_, reach = params_.sonar_beams;
  TwoCounts count;
  memory_.in_sonar().visit(place.beam, y, reach, 1.0, [&](const BinnedPoint& p) {
    if (const LookTime& time = time_of(p); !(far ? time.far : time.counted)) return;
    count.take(p, triangle((static_cast<double>(p.x) - place.beam) / reach) *
                      triangle(static_cast<double>(p.y) - y));
  });
  const double half = 0.5 * scan.num_beams;
  const double across = scan.whole_circle ? reach
                                          : reach * (triangle_below((half - place.beam) / reach) -
                                                     triangle_below((-half - place.beam) / reach));
  const double along = triangle_below(scan.max_range / range_reach_ - y) - triangle_below(-y);
  const double per_cell = rate / scan.num_beams * range_reach_ / scan.max_range;
  const double scale = 1.0 / (kTriangle * kTriangle);
  const double expected = scale * looks * across * along * per_cell;
  return {excess(scale * count.all, expected, sonar_prior()),
          excess(scale * count.free, expected, sonar_prior())};
}

// Calls `use` with each counted return of the earth within a box along a line of sight, and with where it is:
// from the place along that line and across it [m].
template <class Use>
void ClutterMap::visit_earth(const SeenPlace& place, const EarthBox& box, const Use& use) const {
  const Eigen::Vector2d& along = box.along;
  const double north = std::abs(along.x()) * box.down + std::abs(along.y()) * box.across;
  const double east = std::abs(along.y()) * box.down + std::abs(along.x()) * box.across;
  memory_.earth().visit(place.p_earth.x(), place.p_earth.y(), north, east, [&](const BinnedPoint& p) {
    if (!time_of(p).counted) return;
    const double dn = static_cast<double>(p.x) - place.p_earth.x();
    const double de = static_cast<double>(p.y) - place.p_earth.y();
    use(p, dn * along.x() + de * along.y(), de * along.x() - dn * along.y());
  });
}

// Counts of the earth's kernels around a place.
ClutterMap::EarthCounts ClutterMap::count_in_earth(const SeenPlace& place, const EarthBox& box) const {
  EarthCounts counts;
  double squares = 0.0, products = 0.0;
  visit_earth(place, box, [&](const BinnedPoint& p, double down, double across) {
    const double beside = triangle(across / box.across);
    counts.wide.take(p, beside * triangle(down / box.down));
    counts.thin.take(p, beside * triangle(down / (kFine * box.down)));
    const double wide = static_cast<double>(p.weight) * beside * triangle(down / box.down);
    squares += wide * across * across;
    products += wide * across * down;
  });
  if (counts.wide.all < kLine || squares <= 0.0) return counts;
  const double slope = std::clamp(products / squares, -kSteepest, kSteepest);
  EarthBox slanting = box;
  slanting.down = std::abs(slope) * box.across + kFine * box.down;
  visit_earth(place, slanting, [&](const BinnedPoint& p, double down, double across) {
    counts.line.take(p,
                     triangle(across / box.across) * triangle((down - slope * across) / (kFine * box.down)));
  });
  return counts;
}

// The densest of the kernels counts.
ClutterMap::TwoExcesses ClutterMap::earth_excess(const ScanTable& scan, const SeenPlace& place,
                                                 double rate) const {
  const double beam = scan.width_at(place.beam) * place.range;
  const EarthBox box{
      (place.p_earth - Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east)).normalized(),
      range_reach_, std::max(params_.earth_beams * beam, 0.25 * range_reach_)};
  const EarthCounts counts = count_in_earth(place, box);
  if (counts.wide.all <= 0.0) return {};
  const double per_look = rate / scan.num_beams * box.across / beam * range_reach_ / scan.max_range;
  const double scale = 1.0 / (kTriangle * kTriangle);
  const double expected = scale * views_of(place) * per_look;
  const ExcessPrior prior = earth_prior();
  ExcessPrior line = prior;
  line.share *= kLines;
  const auto densest = [&](double wide, double thin, double slanting) {
    return denser(excess(scale * wide, expected, prior),
                  denser(excess(scale * thin, kFine * expected, prior),
                         excess(scale * slanting, kFine * expected, line)));
  };
  return {densest(counts.wide.all, counts.thin.all, counts.line.all),
          densest(counts.wide.free, counts.thin.free, counts.line.free)};
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
  if (num_counted_ == 0.0) return 1.0;
  const double y = place.range / range_reach_;
  double sonar = 0.0, earth = 0.0;
  const auto in_frame = [](double across, double along) {
    const double a = std::abs(across), b = std::abs(along);
    return a <= FrameCounts::kBeams && b <= FrameCounts::kReaches &&
           !(a <= FrameCounts::kMiddleBeams && b <= FrameCounts::kMiddleReaches);
  };
  const PointBins& bins = memory_.in_sonar();
  bins.visit(place.beam, y, FrameCounts::kBeams, FrameCounts::kReaches, [&](const BinnedPoint& p) {
    if (time_of(p).counted && in_frame(static_cast<double>(p.x) - place.beam, static_cast<double>(p.y) - y))
      sonar += static_cast<double>(p.weight);
  });
  const Eigen::Vector2d along =
      (place.p_earth - Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east)).normalized();
  const double beam = scan.width_at(place.beam) * place.range;
  const double box = std::hypot(FrameCounts::kBeams * beam, FrameCounts::kReaches * range_reach_);
  memory_.earth().visit(place.p_earth.x(), place.p_earth.y(), box, box, [&](const BinnedPoint& p) {
    if (!time_of(p).counted) return;
    const double dn = static_cast<double>(p.x) - place.p_earth.x();
    const double de = static_cast<double>(p.y) - place.p_earth.y();
    if (in_frame((de * along.x() - dn * along.y()) / beam, (dn * along.x() + de * along.y()) / range_reach_))
      earth += static_cast<double>(p.weight);
  });
  const double area = 4.0 * (FrameCounts::kBeams * FrameCounts::kReaches -
                             FrameCounts::kMiddleBeams * FrameCounts::kMiddleReaches);
  const double expected = num_counted_ * area * rate / scan.num_beams * range_reach_ / scan.max_range;
  return 1.0 / (1.0 + std::max(excess(sonar, expected, params_.sonar_prior).density(),
                               excess(earth, expected, params_.sonar_prior).density()));
}

// Mean number of looks, each weighted with the density of its background there, that had a place in view.
double ClutterMap::views_of(const SeenPlace& place) const {
  double views = 0.0;
  for (std::size_t k = 0; k < times_.size(); ++k) {
    if (!times_[k].counted) continue;
    const Look& look = memory_.looks()[k];
    const double dn = place.p_earth.x() - look.T_earth_sonar.north;
    const double de = place.p_earth.y() - look.T_earth_sonar.east;
    const double square = dn * dn + de * de;
    if (square > look.max_range * look.max_range) continue;
    if (std::abs(core::wrap_to_pi(std::atan2(de, dn) - look.axis)) > look.half_sector) continue;
    views += place.range / std::max(std::sqrt(square), 0.1 * place.range);
  }
  return views;
}

// What moves with the sonar shows, blurred, in the earth's frame too: only what is denser there stands.
void ClutterMap::learn(const ScanTable& newest, std::span<const double> own, double rate) {
  rate = typical_.at_most(rate);
  mark_looks(newest);
  sonar_dense_.begin_scan();
  if (num_counted_ > 0.0) earth_dense_.begin_scan();
  for (std::size_t j = 0; j < newest.detections.size(); ++j) {
    const SeenPlace place = seen_place(newest, newest.detections[j]);
    const Excess spot = spot_excess(newest, place, rate, true).all,
                 frame = frame_excess(newest, place, rate, false).all;
    const Excess& sonar = denser(spot, frame);
    sonar_dense_.take(1.0 - own[j], sonar.density() > 0.0 ? sonar.probability : 0.0, sonar.rate);
    if (num_counted_ == 0.0) continue;
    const double stands = earth_excess(newest, place, rate).all.density();
    const bool denser = stands > sonar.density();
    earth_dense_.take(1.0, denser ? stands / (1.0 + stands) : 0.0, 1.0 + stands);
  }
}

}  // namespace lookout::csht
