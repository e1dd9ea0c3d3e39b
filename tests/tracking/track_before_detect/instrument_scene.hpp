#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "core/random.hpp"
#include "core/sonar_image.hpp"
#include "sonar_sim/image_model.hpp"

namespace lookout::tracking {

/// A standing sonar of any resolution and what lies before it. Ranges in metres, angles in degrees.
struct InstrumentCase {
  double range_step = 0.5;     ///< [m]
  int num_beams = 90;          ///< Over `sector_deg`.
  double sector_deg = 90.0;    ///< From the first edge to the last.
  double period = 0.5;         ///< Between pings [s].
  double pulse_sigma = 0.55;   ///< [m]
  double beam_null_deg = 1.5;  ///< First null of the beam pattern.
  double max_range = 80.0;     ///< [m]
  double snr_db = 14.0;        ///< Peak amplitude over local rms.
  double speed = 1.0;          ///< Closing [m/s].
  double start_range = 70.0;   ///< At the first ping [m].
  double bearing_deg = 7.3;    ///< Of the target.
  bool target = true;          ///< Whether there is one.
  bool fluctuates = false;     ///< Exponentially distributed power from ping to ping (Swerling 1).
  double stripe_db = 0.0;      ///< Gain of every sixteenth beam.
  bool structure = false;      ///< A bottom from half of the range on, a wall and twelve highlights.
};

/// Draws the pings of a case one by one. Background samples are K-distributed, of shape 4, and independent.
class InstrumentScene {
 public:
  InstrumentScene(const InstrumentCase& c, std::uint64_t seed) : case_(c), random_(seed) {
    plan_.range_step = c.range_step;
    plan_.first_range = 0.5 * c.range_step;
    plan_.num_bins = static_cast<int>(std::lround(c.max_range / c.range_step));
    plan_.beam_null = core::radians(c.beam_null_deg);
    plan_.pulse_sigma = c.pulse_sigma;
    sonar_.num_beams = c.num_beams;
    sonar_.bearing_step = core::radians(c.sector_deg / c.num_beams);
    sonar_.first_bearing = core::radians(-0.5 * c.sector_deg) + 0.5 * sonar_.bearing_step;
    image_ = sonar_sim::empty_image(sonar_, plan_);
    for (int i = 0; i < kBank; ++i) bank_.push_back(draw_background());
    if (c.structure) build();
  }

  /// North, east and their velocities of the target at ping `k`.
  Eigen::Vector4d truth(int k) const {
    const double range = case_.start_range - case_.speed * case_.period * k;
    Eigen::Vector4d state;
    state << core::from_polar(range, core::radians(case_.bearing_deg)),
        core::from_polar(-case_.speed, core::radians(case_.bearing_deg));
    return state;
  }

  /// Ping `k`, in any order; the sonar stands at the origin and looks north.
  core::PosedImage ping(int k) {
    image_.utime = core::microseconds(case_.period * k);
    image_.sequence = k;
    std::vector<std::complex<double>> field(image_.intensity.size());
    if (case_.target) add_target(k, field);
    for (const sonar_sim::ImageTarget& echo : standing_)
      sonar_sim::add_echo(image_, plan_, {echo.range, echo.bearing, echo.snr_db, phase(), 1.0}, field);
    for (int beam = 0; beam < case_.num_beams; ++beam) fill_beam(beam, field);
    return {image_, {}};
  }

 private:
  static constexpr int kBank = 1 << 18;
  static constexpr double kBottomGain = 4.0;
  static constexpr double kWallSnr = 15.0;  // [dB]

  /// A complex sample whose amplitude is K-distributed with rms 1. [Jakeman1976]
  std::complex<double> draw_background() {
    const double texture = std::gamma_distribution<double>(*plan_.shape, 1.0 / *plan_.shape)(random_);
    const double sigma = std::sqrt(0.5 * texture);
    return {random_.gaussian(sigma), random_.gaussian(sigma)};
  }

  double phase() { return random_.uniform(0.0, 2.0 * std::numbers::pi); }

  void build() {
    for (int i = 0; i < 12; ++i)
      standing_.push_back({random_.uniform(0.1, 0.95) * case_.max_range,
                           core::radians(0.48 * case_.sector_deg * random_.uniform(-1.0, 1.0)),
                           random_.uniform(14.0, 26.0), 0.0, 1.0});
    for (int i = 0; i < 40; ++i) {  // a wall aslant, a point every third of a metre
      const Eigen::Vector2d p(0.4 * case_.max_range + 0.3 * i, -0.2 * case_.max_range + 0.15 * i);
      standing_.push_back({p.norm(), std::atan2(p.y(), p.x()), kWallSnr, 0.0, 1.0});
    }
  }

  void add_target(int k, std::vector<std::complex<double>>& field) {
    const double fading = case_.fluctuates ? -std::log(1.0 - random_.uniform(0.0, 1.0)) : 1.0;
    const Eigen::Vector4d p = truth(k);
    const double snr_db = case_.snr_db + 10.0 * std::log10(std::max(1e-6, fading));
    sonar_sim::add_echo(image_, plan_,
                        {p.head<2>().norm(), core::radians(case_.bearing_deg), snr_db, phase(), 1.0}, field);
  }

  void fill_beam(int beam, const std::vector<std::complex<double>>& field) {
    const double gain = beam % 16 == 5 ? std::pow(10.0, case_.stripe_db / 20.0) : 1.0;
    const double bottom = (0.5 + 0.1 * std::sin(0.1 * beam * 90.0 / case_.num_beams)) * case_.max_range;
    auto cell = static_cast<std::size_t>(beam) * static_cast<std::size_t>(plan_.num_bins);
    auto at = static_cast<std::size_t>(random_.index(kBank));
    for (int bin = 0; bin < plan_.num_bins; ++bin, ++cell) {
      const double range = plan_.first_range + bin * plan_.range_step;
      const double rough = case_.structure && range > bottom ? kBottomGain : 1.0;
      at = (at + 1) % kBank;
      image_.intensity[cell] =
          gain * std::abs(field[cell] + rough * plan_.background_level(range) * bank_[at]);
    }
  }

  InstrumentCase case_;
  core::Random random_;
  sonar_sim::ImagePlan plan_;
  core::SonarParams sonar_;
  core::SonarImage image_;
  std::vector<std::complex<double>> bank_;
  std::vector<sonar_sim::ImageTarget> standing_;
};

}  // namespace lookout::tracking
