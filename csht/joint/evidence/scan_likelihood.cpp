#include "csht/joint/evidence/scan_likelihood.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "csht/likelihood/fast_math.hpp"

namespace lookout::csht {
namespace {

constexpr double kCompatibleSigmas = 2.5;     // A detection this near to a track's range is explained by it.
constexpr double kLeastUndetected = 1e-9;     // Stands for none, so that its logarithm is finite.
constexpr double kImpossible = -1e6;          // ln of the density of what the prior rules out [nats].
constexpr std::size_t kClaimsReserved = 512;  // Of a scan; more are possible, but allocate.

// Whether a claim on one beam may be one on the return of another: the beam beside it, or one of its group.
bool one_return(const ScanTable& scan, int claimed, int beam) {
  if (std::abs(claimed - beam) <= 1) return true;
  const std::int16_t group = scan.group[static_cast<std::size_t>(beam) + 1];
  return group >= 0 && scan.group[static_cast<std::size_t>(claimed) + 1] == group;
}

}  // namespace

int beam_at(const ScanTable& scan, double north, double east) {
  const auto dn = static_cast<float>(north - scan.T_earth_sonar.north);
  const auto de = static_cast<float>(east - scan.T_earth_sonar.east);
  const auto cos_axis = static_cast<float>(scan.cos_axis);
  const auto sin_axis = static_cast<float>(scan.sin_axis);
  const float bearing = fast_atan2(cos_axis * de - sin_axis * dn, cos_axis * dn + sin_axis * de);
  return static_cast<int>(
      std::floor(scan.beams_from_middle(static_cast<double>(bearing)) + 0.5 * scan.num_beams));
}

ScanLikelihood::ScanLikelihood(const SensorFigures& figures, const SensorModelParams& model,
                               const Tolerance& tolerance, int capacity, int max_owners,
                               const TargetPrior& prior)
    : tolerance_(tolerance),
      scans_(figures, model, capacity),
      prior_(prior),
      log_undetected_(static_cast<std::size_t>(capacity)),
      claims_(static_cast<std::size_t>(capacity)) {
  for (auto& claims : claims_) claims.reserve(kClaimsReserved);
  existence_.assign(static_cast<std::size_t>(max_owners), 0.0);
}

void ScanLikelihood::push(const core::PosedScan& scan, double undetected, int sensor) {
  scans_.push(scan, sensor);
  if (scans_.pushed() == 1) first_utime_ = scans_.newest().utime;
  log_undetected_[ring_index(0)] = std::log(std::max(undetected, kLeastUndetected));
  claims_at(0).clear();
}

std::size_t ScanLikelihood::ring_index(int age) const {
  assert(age >= 0 && age < scans_.size());
  return static_cast<std::size_t>((scans_.pushed() - 1 - age) % scans_.capacity());
}

std::vector<Claim>& ScanLikelihood::claims_at(int age) {
  return claims_[ring_index(age)];
}
const std::vector<Claim>& ScanLikelihood::claims_at(int age) const {
  return claims_[ring_index(age)];
}

void ScanLikelihood::set_existence(int owner, double existence) {
  existence_[static_cast<std::size_t>(owner)] = existence;
}

void ScanLikelihood::add_claim(int age, const Claim& claim) {
  claims_at(age).push_back(claim);
}

void ScanLikelihood::forget_claims(int owner) {
  for (auto& claims : claims_) std::erase_if(claims, [owner](const Claim& c) { return c.owner == owner; });
}

void ScanLikelihood::forget_claims(int owner, int age) {
  std::erase_if(claims_at(age), [owner](const Claim& c) { return c.owner == owner; });
}

const BeamMask* ScanLikelihood::mask(int age, int self, int beam) {
  const ScanTable& scan = scans_.at_age(age);
  const bool points = scan.clutter == ClutterModel::point;
  bool any = false;
  for (const Claim& claim : claims_at(age)) {
    const double existence = existence_[static_cast<std::size_t>(claim.owner)];
    if (claim.owner == self || existence < kLeastExistence) continue;
    if (!points && beam >= 0 && std::abs(claim.index - beam) > kNeighbourhood) continue;
    if (!any) mask_.clear(scan);
    any = true;
    const double share = existence * static_cast<double>(claim.share);
    if (points)
      claim_detection(static_cast<std::size_t>(claim.index), share, mask_);
    else
      claim_beam(scan, claim, share);
  }
  return any ? &mask_ : nullptr;
}

bool ScanLikelihood::contested(int self, const Trajectory& mean) {
  const ScanTable& scan = scans_.newest();
  if (scan.clutter != ClutterModel::point)
    return mask(0, self, std::max(0, beam_at(scan, mean[0], mean[1]))) != nullptr;
  const double north = mean[0] - scan.T_earth_sonar.north, east = mean[1] - scan.T_earth_sonar.east;
  const double range = std::hypot(north, east), azimuth = std::atan2(east, north);
  return std::any_of(claims_at(0).begin(), claims_at(0).end(), [&](const Claim& claim) {
    if (claim.owner == self || existence_[static_cast<std::size_t>(claim.owner)] < kLeastExistence)
      return false;
    const core::Detection& detection = scan.detections[static_cast<std::size_t>(claim.index)];
    const double dr = (detection.range - range) * static_cast<double>(scan.inverse_sigma);
    const double db =
        core::wrap_to_pi(detection.azimuth - azimuth) * static_cast<double>(scan.inverse_bearing_sigma);
    return dr * dr + db * db <= kCompatibleSigmas * kCompatibleSigmas;
  });
}

// A return that does not fit the owner of its beam would speak strongly for a nearer target there. It is not
// let do so: the owner's own beam may well be the next one.
void ScanLikelihood::claim_beam(const ScanTable& scan, const Claim& claim, double share) {
  csht::claim_beam(scan, claim.index, static_cast<double>(claim.range), share, mask_);
  float& nearer = mask_.nearer[static_cast<std::size_t>(claim.index) + 1];
  nearer = std::min(nearer, 1.0F);
  claim_group(scan, claim, share);
}

// Where the return of the claimed beam is one of a group, its owner made the others too: to another target
// they say no more than what is hidden does.
void ScanLikelihood::claim_group(const ScanTable& scan, const Claim& claim, double share) {
  const std::size_t slot = static_cast<std::size_t>(claim.index) + 1;
  const std::int16_t group = scan.group[slot];
  const double gate = kCompatibleSigmas / static_cast<double>(scan.inverse_sigma);
  if (group < 0 || std::abs(static_cast<double>(claim.range - scan.range[slot])) > gate) return;
  const int reach = 2 * SpillModel::kReach;
  for (int beam = std::max(0, claim.index - reach); beam <= std::min(scan.num_beams - 1, claim.index + reach);
       ++beam) {
    const std::size_t other = static_cast<std::size_t>(beam) + 1;
    if (beam == claim.index || scan.group[other] != group) continue;
    csht::claim_beam(scan, beam, static_cast<double>(scan.range[other]) - gate, share, mask_);
    mask_.nearer[other] = std::min(mask_.nearer[other], 1.0F);
  }
}

double ScanLikelihood::explained(int age, int index, double range, std::span<const char> owners) const {
  const ScanTable& scan = scans_.at_age(age);
  const bool points = scan.clutter == ClutterModel::point;
  const double gate = kCompatibleSigmas / static_cast<double>(scan.inverse_sigma);
  double sum = 0.0;
  for (const Claim& claim : claims_at(age)) {
    if (!owners.empty() && owners[static_cast<std::size_t>(claim.owner)] == 0) continue;
    const bool same = points ? claim.index == index
                             : one_return(scan, claim.index, index) &&
                                   std::abs(static_cast<double>(claim.range) - range) <= gate;
    if (same) sum += existence_[static_cast<std::size_t>(claim.owner)] * static_cast<double>(claim.share);
  }
  return std::min(sum, 1.0);
}

void ScanLikelihood::begin(const HypothesisSpan& hypotheses, double seconds, int oldest,
                           std::span<double> log_ratio) {
  const ScanTable& scan = scans_.at_age(oldest);
  range_.resize(hypotheses.size());
  bearing_.resize(hypotheses.size());
  locate(scan, hypotheses, seconds, range_, bearing_);
  const auto half_sector = static_cast<float>(0.5 * scan.num_beams * scan.bearing_step);
  const auto max_range = static_cast<float>(scan.max_range);
  const double log_undetected = log_undetected_[ring_index(oldest)];
  const double log_outside = prior_.in_view_from_start() ? kImpossible : 0.0;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const bool in_view = range_[i] <= max_range && std::abs(bearing_[i]) <= half_sector;
    log_ratio[i] = in_view ? log_undetected : log_outside;
  }
}

void ScanLikelihood::add(const TrajectoryCloud& cloud, const Trajectory& mean, const AgeSpan& ages, int self,
                         std::span<double> log_ratio) {
  if (ages.births) begin_cloud(cloud, ages.oldest, log_ratio);
  for (int age = ages.oldest; age >= ages.newest; --age) {
    if (ages.births) add_births(log_birth(age), log_ratio);
    const BeamMask* others = nullptr;
    if (self != kEverybody && !claims_at(age).empty()) {
      const Eigen::Vector2d at = position_at(cloud.motion, mean, scans_.seconds_at_age(age));
      others = mask(age, self, std::max(0, beam_at(scans_.at_age(age), at.x(), at.y())));
    }
    // In the short window of a new target it strays by less than the sensor errs.
    add_scan(cloud, age, others, self == kNobody ? tolerance_ : tolerance_at(age, mean), log_ratio);
  }
}

Tolerance ScanLikelihood::tolerance_at(int age, const Trajectory& mean) const {
  if (!wander_.active()) return tolerance_;
  const core::Pose2& sonar = scans_.newest().T_earth_sonar;
  const double memory =
      wander_.memory(scans_.figures(), std::hypot(mean[0] - sonar.north, mean[1] - sonar.east));
  return wander_.at_age(-scans_.seconds_at_age(age), memory, tolerance_);
}

void ScanLikelihood::begin_cloud(const TrajectoryCloud& cloud, int oldest, std::span<double> log_ratio) {
  const double seconds = scans_.seconds_at_age(oldest);
  if (cloud.motion == Motion::constant_velocity) {
    begin(cloud.span(), seconds, oldest, log_ratio);
    return;
  }
  cloud.place(seconds, moved_);
  begin(moved_.span(), 0.0, oldest, log_ratio);
}

void ScanLikelihood::add_scan(const TrajectoryCloud& cloud, int age, const BeamMask* mask,
                              const Tolerance& tolerance, std::span<double> log_ratio) {
  const double seconds = scans_.seconds_at_age(age);
  if (cloud.motion == Motion::constant_velocity) {
    add_log_ratio(scans_.at_age(age), mask, cloud.span(), seconds, tolerance, log_ratio);
    return;
  }
  cloud.place(seconds, moved_);
  add_log_ratio(scans_.at_age(age), mask, moved_.span(), 0.0, tolerance, log_ratio);
}

}  // namespace lookout::csht
