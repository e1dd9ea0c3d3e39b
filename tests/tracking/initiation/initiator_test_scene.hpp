#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/random.hpp"
#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/plots/plot_window.hpp"

namespace lookout::tracking::test {

/// A target on a straight course.
struct Course {
  Eigen::Vector2d start{0, 0};     ///< [m].
  Eigen::Vector2d velocity{0, 0};  ///< [m/s].
};

/// Seven scans of 2 s, the timing of [Fan2018]; noise-free plots of all courses first, then clutter.
struct SceneOptions {
  int scans = 7;
  double period = 2.0;
  int clutter = 0;             ///< Plots a scan.
  double half_width = 4000.0;  ///< Of the square that the clutter fills [m].
  double sigma = 5.0;          ///< Of the plots that is stated, and drawn where `noisy` [m].
  bool noisy = false;
};

inline PlotWindow scene_of(const std::vector<Course>& courses, const SceneOptions& options,
                           core::Random& random) {
  PlotWindow window;
  Plot plot;
  plot.noise = options.sigma * options.sigma * Eigen::Matrix2d::Identity();
  for (int k = 0; k < options.scans; ++k) {
    const double time = k * options.period;
    window.begin_scan(time);
    for (const Course& course : courses) {
      plot.position = course.start + time * course.velocity;
      if (options.noisy)
        plot.position += Eigen::Vector2d(random.gaussian(options.sigma), random.gaussian(options.sigma));
      window.add(plot);
    }
    for (int i = 0; i < options.clutter; ++i) {
      const double reach = options.half_width;
      plot.position = {random.uniform(-reach, reach), random.uniform(-reach, reach)};
      window.add(plot);
    }
  }
  return window;
}

/// What suits that timing for every method: the speeds of [Fan2018], a range that holds the scene, cells as
/// fine in proportion as those of [Zeng2023].
inline InitiatorConfig config_for_tests() {
  InitiatorConfig config;
  config.position_sigma = 5.0;
  config.min_speed = 100.0;
  config.max_speed = 400.0;
  config.acceleration_sigma = 0.0;
  config.sensor_range = 6000.0;
  return config;
}

/// What the cells of a Hough method hold after its last window.
struct Votes {
  double highest = 0.0;
  double sum = 0.0;
};
inline Votes votes_of(const Initiator& method) {
  std::vector<LineVote> cells;
  dynamic_cast<const HoughInitiator&>(method).append_cells(cells);
  Votes votes;
  for (const LineVote& cell : cells) {
    votes.highest = std::max(votes.highest, cell.value);
    votes.sum += cell.value;
  }
  return votes;
}

}  // namespace lookout::tracking::test
