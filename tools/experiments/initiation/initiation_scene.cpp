#include "tools/experiments/initiation/initiation_scene.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "core/files/csv.hpp"
#include "tools/cli/paths.hpp"
#include "tracking/initiation/initiator_config.hpp"

namespace lookout::tools {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// An upright box [m].
struct Box {
  Eigen::Vector2d low{0, 0};
  Eigen::Vector2d high{0, 0};
};

/// One target's true state.
struct Target {
  Eigen::Vector2d position{0, 0};
  Eigen::Vector2d velocity{0, 0};
};

void add_plot(InitiationScene& scene, const Eigen::Vector2d& position, const Eigen::Matrix2d& noise,
              int target) {
  tracking::Plot plot;
  plot.position = position;
  plot.noise = noise;
  plot.source = static_cast<int>(scene.target_of.size());
  scene.scans.back().push_back(plot);
  scene.target_of.push_back(target);
}

/// Clutter, uniform in `box`, with the noise that `noise_at` says of each place.
template <typename NoiseAt>
void add_clutter(InitiationScene& scene, const Box& box, double mean, const NoiseAt& noise_at,
                 core::Random& random) {
  for (int left = random.poisson(mean); left > 0; --left) {
    const double x = random.uniform(box.low.x(), box.high.x());
    const double y = random.uniform(box.low.y(), box.high.y());
    add_plot(scene, {x, y}, noise_at(Eigen::Vector2d(x, y)), -1);
  }
}

/// The same number in the mean, in clusters.
template <typename NoiseAt>
void add_clustered_clutter(InitiationScene& scene, const Box& box, double mean, const NoiseAt& noise_at,
                           core::Random& random) {
  constexpr int kPlots = 5;          // Of a cluster.
  constexpr double kSigma = 1000.0;  // Of its plots along each axis [m].
  for (int left = random.poisson(mean / kPlots); left > 0; --left) {
    const Eigen::Vector2d centre(random.uniform(box.low.x(), box.high.x()),
                                 random.uniform(box.low.y(), box.high.y()));
    for (int k = 0; k < kPlots; ++k) {
      const double x = centre.x() + random.gaussian(kSigma);
      const double y = centre.y() + random.gaussian(kSigma);
      add_plot(scene, {x, y}, noise_at(Eigen::Vector2d(x, y)), -1);
    }
  }
}

/// A target moved on by a step of its own motion, without noise: on a turn, or faster.
void steer(Target& target, double seconds, double turn_rate, double acceleration) {
  const Eigen::Vector2d velocity = target.velocity;
  if (turn_rate != 0.0) {
    Eigen::Matrix2d quarter;
    quarter << 0.0, -1.0, 1.0, 0.0;
    const double angle = turn_rate * seconds;
    target.position +=
        (std::sin(angle) * velocity + (1.0 - std::cos(angle)) * (quarter * velocity)) / turn_rate -
        seconds * velocity;
    target.velocity = std::cos(angle) * velocity + std::sin(angle) * (quarter * velocity);
  }
  if (acceleration == 0.0) return;
  const Eigen::Vector2d gained = seconds * acceleration * target.velocity.normalized();
  target.position += 0.5 * seconds * gained;
  target.velocity += gained;
}

/// The mean of the true positions and the direction from the first to the last.
void describe_course(InitiationScene& scene, const std::vector<Points>& courses) {
  scene.num_targets = static_cast<int>(courses.size());
  for (const Points& course : courses) {
    const Eigen::Vector2d sum =
        std::accumulate(course.begin(), course.end(), Eigen::Vector2d(Eigen::Vector2d::Zero()));
    scene.centres.push_back(sum / static_cast<double>(course.size()));
    scene.directions.push_back((course.back() - course.front()).normalized());
  }
}

bool noisy(const FanSceneParams& params) {
  return params.situation == "II" || params.situation == "IV";
}

bool cluttered(const FanSceneParams& params) {
  return params.situation == "III" || params.situation == "IV";
}

}  // namespace

tracking::PlotWindow InitiationScene::window() const {
  tracking::PlotWindow window;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    window.begin_scan(times[k]);
    for (const auto& plot : scans[k]) window.add(plot);
  }
  return window;
}

double plot_sigma(const FanSceneParams& params) {
  return params.noise == "printed" ? 10.0 : 1.0;
}

double acceleration_sigma(const FanSceneParams& params) {
  return params.noise == "printed" ? 5.0 : 0.0;  // 10 m/s over a step of 2 s
}

InitiationScene fan_scene(const FanSceneParams& params, core::Random& random) {
  constexpr int kScans = 7;
  constexpr double kPeriod = 2.0;
  const double second_vy = params.printed_signs ? -100.0 : 100.0;
  std::array<Target, 3> targets{Target{{300.0, 400.0}, {280.0, 49.0}},
                                Target{{3000.0, 300.0}, {-173.2, second_vy}},
                                Target{{2100.0, 1300.0}, {-173.2, -100.0}}};
  const double sigma = noisy(params) ? plot_sigma(params) : 0.0;
  const double push = noisy(params) ? acceleration_sigma(params) * kPeriod : 0.0;
  // A method is told what the sensor states; the ideal scans are better than that.
  const Eigen::Matrix2d stated = plot_sigma(params) * plot_sigma(params) * Eigen::Matrix2d::Identity();
  InitiationScene scene;
  std::vector<Points> courses(targets.size());
  for (int k = 0; k < kScans; ++k) {
    scene.times.push_back(k * kPeriod);
    scene.scans.emplace_back();
    for (std::size_t i = 0; i < targets.size(); ++i) {
      courses[i].push_back(targets[i].position);
      const Eigen::Vector2d error(random.gaussian(1.0), random.gaussian(1.0));
      if (params.detection_probability == 1.0 || random.uniform(0.0, 1.0) < params.detection_probability)
        add_plot(scene, targets[i].position + sigma * error, stated, static_cast<int>(i));
      // Eq. (33) as printed, input [T/2; 1]: the noise is a change of velocity.
      const Eigen::Vector2d change = push * Eigen::Vector2d(random.gaussian(1.0), random.gaussian(1.0));
      targets[i].position += kPeriod * targets[i].velocity + 0.5 * kPeriod * change;
      targets[i].velocity += change;
    }
    if (cluttered(params))
      add_clutter(
          scene, {{0.0, 0.0}, {4000.0, 1600.0}}, params.clutter_per_scan,
          [&](const Eigen::Vector2d&) { return stated; }, random);
  }
  describe_course(scene, courses);
  return scene;
}

InitiationScene real_scene(double clutter_per_scan, double position_sigma, core::Random& random) {
  static constexpr std::array<std::string_view, 7> kColumns{"time", "x1", "y1", "x2", "y2", "x3", "y3"};
  constexpr double kPeriod = 10.0;
  const core::CsvTable table(tools_directory() + "/data/fan2018_table3.csv", kColumns);
  const Eigen::Matrix2d stated = position_sigma * position_sigma * Eigen::Matrix2d::Identity();
  InitiationScene scene;
  std::vector<Points> courses(3);
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    scene.times.push_back(kPeriod * table.number(row, "time"));
    scene.scans.emplace_back();
    for (std::size_t i = 0; i < courses.size(); ++i) {
      courses[i].emplace_back(table.number(row, kColumns[1 + 2 * i]), table.number(row, kColumns[2 + 2 * i]));
      add_plot(scene, courses[i].back(), stated, static_cast<int>(i));
    }
    add_clutter(
        scene, {{-25e3, 12e3}, {0.0, 30e3}}, clutter_per_scan, [&](const Eigen::Vector2d&) { return stated; },
        random);
  }
  describe_course(scene, courses);
  return scene;
}

namespace {

/// The five targets of [Zeng2023] section 3.1 at the first scan.
std::array<Target, 5> zeng_targets() {
  std::array<Target, 5> targets;
  const double kilometres[5][2] = {{55, 55}, {45, 45}, {35, 35}, {45, 25}, {55, 15}};
  for (std::size_t i = 0; i < targets.size(); ++i)
    targets[i] = {1e3 * Eigen::Vector2d(kilometres[i][0], kilometres[i][1]), {500.0, 0.0}};
  return targets;
}

}  // namespace

InitiationScene zeng_scene(const ZengSceneParams& params, core::Random& random) {
  constexpr double kPeriod = 5.0;
  const Eigen::Vector2d acceleration_sigma(1.0, 0.6);
  std::array<Target, 5> targets = zeng_targets();
  const auto noise_at = [&](const Eigen::Vector2d& p) {
    return tracking::polar_noise(p, params.told_noise * params.range_sigma,
                                 params.told_noise * params.azimuth_sigma);
  };
  InitiationScene scene;
  std::vector<Points> courses(targets.size());
  for (int k = 0; k < params.num_scans; ++k) {
    scene.times.push_back(k * kPeriod);
    scene.scans.emplace_back();
    for (std::size_t i = 0; i < targets.size(); ++i) {
      Target& target = targets[i];
      courses[i].push_back(target.position);
      const double range = target.position.norm() + random.gaussian(params.range_sigma);
      const double azimuth =
          std::atan2(target.position.x(), target.position.y()) + random.gaussian(params.azimuth_sigma);
      const Eigen::Vector2d measured(range * std::sin(azimuth), range * std::cos(azimuth));
      if (random.uniform(0.0, 1.0) < params.detection_probability)
        add_plot(scene, measured, noise_at(measured), static_cast<int>(i));
      const Eigen::Vector2d push(random.gaussian(acceleration_sigma.x()),
                                 random.gaussian(acceleration_sigma.y()));
      const Eigen::Vector2d way = kPeriod * target.velocity + 0.5 * kPeriod * kPeriod * push;
      steer(target, kPeriod, i % 2 == 0 ? params.turn_rate : -params.turn_rate, params.acceleration);
      target.position += way;
      target.velocity += kPeriod * push;
    }
    const Box square{{0.0, 0.0}, {100e3, 100e3}};
    if (params.clustered)
      add_clustered_clutter(scene, square, params.clutter_per_scan, noise_at, random);
    else
      add_clutter(scene, square, params.clutter_per_scan, noise_at, random);
  }
  describe_course(scene, courses);
  return scene;
}

}  // namespace lookout::tools
