#include "tools/experiments/fusion/fused_run.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <stdexcept>

#include "core/random.hpp"
#include "lcmtypes/compact_estimate.hpp"
#include "lcmtypes/message_size.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

/// One vehicle: what its sonar hears, its tracker and its link.
class Vehicle {
 public:
  Vehicle(const sonar_sim::Scene& scene, const FusedRunParams& params, std::uint64_t seed, int run,
          std::size_t index)
      : scans_(simulate(scene, seed, run, index)),
        sonar_(told(scene.platforms[index].sonar.params)),
        tracker_name_(params.tracker),
        seed_(run_seed(seed, run) + index),
        node_id_(scene.platforms[index].node_id),
        outage_(params.outage),
        sender_(link_of(params, scene.platforms[index].node_id), message_bytes(params)),
        acoustic_(params.acoustic),
        fate_(seed, core::RandomStream::experiment,
              static_cast<std::uint64_t>(run) * scene.platforms.size() + index) {}

  std::size_t num_scans() const { return scans_.size(); }
  const TimedScan& scan(std::size_t k) const { return scans_[k]; }
  std::int32_t node_id() const { return node_id_; }
  const tracking::LocalEstimateSender& sender() const { return sender_; }

  /// Tracks scan `k`; nothing while the vehicle is dead.
  std::vector<core::Track> track(std::size_t k) {
    const double time = core::seconds(scans_[k].posed.scan.utime);
    const bool dead = outage_.node_id == node_id_ && time >= outage_.begin && time < outage_.end;
    if (dead) {
      pipeline_.reset();
      return {};
    }
    if (!pipeline_) pipeline_ = pipeline_of(tracker_name_, sonar_, seed_);
    const auto tracks = pipeline_->step(scans_[k].posed).tracks;
    return {tracks.begin(), tracks.end()};
  }

  /// What of the vehicle's estimates arrives at the time of scan `k`.
  std::vector<core::LocalEstimate> send(std::size_t k, const std::vector<core::Track>& tracks) {
    const auto& posed = scans_[k].posed;
    const Eigen::Vector2d p_earth_sonar(posed.T_earth_sonar.north, posed.T_earth_sonar.east);
    const auto sent = sender_.select({posed.scan.utime, static_cast<std::int64_t>(k), p_earth_sonar}, tracks);
    if (acoustic_.turn == 0.0) return {sent.begin(), sent.end()};
    for (const core::LocalEstimate& estimate : sent) transmit(estimate);
    return arrivals(posed.scan.utime);
  }

 private:
  /// The geometry and the accuracy; the probabilities are for the tracker to find out.
  static core::SonarParams told(core::SonarParams sonar) {
    sonar.miss_probability.reset();
    sonar.false_alarm_probability.reset();
    return sonar;
  }

  static int message_bytes(const FusedRunParams& params) {
    return params.acoustic.turn > 0.0 ? static_cast<int>(lcmtypes::kCompactBytes)
                                      : lcmtypes::local_estimate_bytes(params.link.with_covariance);
  }

  static tracking::LocalEstimateSenderParams link_of(const FusedRunParams& params, std::int32_t node_id) {
    tracking::LocalEstimateSenderParams link = params.link;
    link.node_id = node_id;
    if (params.acoustic.turn > 0.0) {
      link.with_covariance = true;
      link.burst_bytes = static_cast<double>(lcmtypes::kCompactBytes);
      link.bytes_per_second = link.burst_bytes / params.acoustic.turn;
    }
    return link;
  }

  void transmit(const core::LocalEstimate& estimate) {
    const auto packet = lcmtypes::pack(estimate);
    if (!packet) throw std::invalid_argument("an estimate does not fit the acoustic packet");
    if (fate_.uniform(0.0, 1.0) < acoustic_.loss) return;
    under_way_.push_back({estimate.utime + core::microseconds(acoustic_.delay), *packet});
  }

  std::vector<core::LocalEstimate> arrivals(std::int64_t now) {
    std::vector<core::LocalEstimate> arrived;
    for (; !under_way_.empty() && under_way_.front().first <= now; under_way_.pop_front())
      arrived.push_back(lcmtypes::unpack(under_way_.front().second, now).value());
    return arrived;
  }

  std::vector<TimedScan> scans_;
  core::SonarParams sonar_;
  std::string tracker_name_;
  std::uint64_t seed_;
  std::int32_t node_id_;
  Outage outage_;
  std::unique_ptr<tracking::ScanPipeline> pipeline_;
  tracking::LocalEstimateSender sender_;
  AcousticLink acoustic_;
  core::Random fate_;                                                         ///< Of packets.
  std::deque<std::pair<std::int64_t, lcmtypes::CompactEstimate>> under_way_;  ///< With their arrival [us].
};

std::vector<Vehicle> make_vehicles(const sonar_sim::Scene& scene, const FusedRunParams& params,
                                   std::uint64_t seed, int run) {
  std::vector<Vehicle> vehicles;
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) vehicles.emplace_back(scene, params, seed, run, i);
  for (const Vehicle& vehicle : vehicles) {
    if (vehicle.num_scans() != vehicles.front().num_scans())
      throw std::invalid_argument("the vehicles of a fused run must scan at the same times");
  }
  return vehicles;
}

/// Everything that one vehicle at least sees.
core::GroundTruth either_sees(const std::vector<core::GroundTruth>& own) {
  core::GroundTruth truth = own.front();
  for (std::size_t i = 0; i < truth.targets.size(); ++i) {
    truth.targets[i].visible = std::any_of(
        own.begin(), own.end(), [&](const core::GroundTruth& seen) { return seen.targets[i].visible; });
  }
  return truth;
}

FusedScan run_scan(std::vector<Vehicle>& vehicles, fusion::Fusion& fusion, std::size_t k) {
  FusedScan result;
  for (Vehicle& vehicle : vehicles) {
    result.own_truth.push_back(vehicle.scan(k).truth);
    result.own_tracks.push_back(vehicle.track(k));
    for (const auto& estimate : vehicle.send(k, result.own_tracks.back())) fusion.add(estimate);
  }
  result.truth = either_sees(result.own_truth);
  const auto fused = fusion.update(result.truth.utime);
  result.fused.assign(fused.begin(), fused.end());
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    auto& associated = result.global_of.emplace_back();
    for (const core::Track& track : result.own_tracks[i]) {
      if (track.status == core::TrackStatus::confirmed)
        associated.emplace_back(track.id, fusion.global_of(vehicles[i].node_id(), track.id));
    }
  }
  return result;
}

}  // namespace

FusedRun run_fused(const sonar_sim::Scene& scene, const FusedRunParams& params, std::uint64_t seed, int run) {
  std::vector<Vehicle> vehicles = make_vehicles(scene, params, seed, run);
  fusion::Fusion fusion(params.fusion);
  FusedRun result;
  for (std::size_t k = 0; k < vehicles.front().num_scans(); ++k)
    result.scans.push_back(run_scan(vehicles, fusion, k));
  for (const Vehicle& vehicle : vehicles) {
    result.links.push_back({static_cast<double>(vehicle.sender().bytes_sent()) / scene.duration,
                            vehicle.sender().most_bytes_in_a_second(), vehicle.sender().longest_wait()});
  }
  return result;
}

}  // namespace lookout::tools
