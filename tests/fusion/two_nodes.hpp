#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "fusion/fusion.hpp"
#include "tests/fusion/test_nodes.hpp"

/// The whole of fusion on two nodes and two targets, for what must hold from message to picture.
namespace lookout::fusion::testing {

/// Target 1 goes north at 2 m/s from the origin; target 2 east at 1 m/s from 60 m north.
inline Eigen::Vector4d target(int id, double time) {
  return core::moved(id == 1 ? Eigen::Vector4d(0, 0, 2, 0) : Eigen::Vector4d(60, 0, 0, 1), time);
}

/// Two nodes that send all targets every half second.
class TwoNodes : public ::testing::Test {
 protected:
  void send(std::int32_t node, int id, double time, double stamp, std::int64_t track_id) {
    LocalEstimate message = estimate(node, track_id, stamp, target(id, time));
    message.p_earth_node = {-50.0, node * 40.0};
    fusion.add(message);
  }
  void send(std::int32_t node, int id, double time) { send(node, id, time, time, id); }

  /// Both nodes, both targets, from `begin` to `end` [s], both included.
  std::vector<core::Track> run(double begin, double end) {
    for (double time = begin; time <= end; time += 0.5) {
      for (std::int32_t node : {1, 2}) {
        for (int id : {1, 2}) send(node, id, time);
      }
      update(time);
    }
    return tracks;
  }

  void update(double time) {
    const auto fused = fusion.update(core::microseconds(time));
    tracks.assign(fused.begin(), fused.end());
  }

  double error(std::size_t index, int id, double time) const {
    return (tracks[index].state - target(id, time)).norm();
  }

  Fusion fusion{FusionParams{}};
  std::vector<core::Track> tracks;
};

}  // namespace lookout::fusion::testing
