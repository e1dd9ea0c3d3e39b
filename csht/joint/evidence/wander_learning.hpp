#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/likelihood/beam_mask.hpp"
#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// What a stream says of how targets stray.
struct WanderEstimate {
  double probability = 0.0;   ///< That they stray.
  double rate = 0.0;          ///< If so, geometric mean of the rate [m/s per root second],
  double log_sigma = 0.0;     ///< and standard deviation of its logarithm.
  double error_factor = 1.0;  ///< Of the sensor's errors over the stated ones, geometric mean.
};

/// How targets stray and how large the errors are, learnt from a point sensor's stream: each of a few rates
/// of white noise acceleration with each of a few factors on the sensor's errors is as probable as a Kalman
/// filter with both foretells the returns of sure targets. The rates are those whose filters remember 4 to 16
/// scans: a filter of a faster one has forgotten what it is to foretell by, and a slower one shows too late
/// to be of use. docs/joint_tracker.md.
class WanderLearning {
 public:
  /// Where the sensor's parameters state a rate, the errors alone are learnt; by a sensor with beams nothing.
  explicit WanderLearning(const core::SonarParams& sonar);

  /// Takes in what the newest scan says of a sure target. @param track before the scan is taken into it.
  /// @param mask what other targets own of the scan; may be null.
  void take(const TargetTrack& track, const ScanTable& scan, const BeamMask* mask);

  WanderEstimate estimate() const;  ///< By the evidence so far.

 private:
  static constexpr std::array kFactors{0.5, 0.71, 1.0, 1.41, 2.0};   ///< On both of the sensor's errors.
  static constexpr std::array kMemories{16.0, 11.3, 8.0, 5.7, 4.0};  ///< Of the rates' filters [scans].
  static constexpr std::size_t kRates = kMemories.size() + 1;        ///< The first is 0.
  static constexpr std::size_t kFilters = kFactors.size() * kRates;
  static constexpr std::size_t kGating = 3 * kRates - 1;  ///< The errors as stated and the fastest rate.

  struct Filter {  ///< North, east [m], north and east velocity [m/s].
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  };
  struct Bank {  ///< The filters of a track.
    std::int64_t track = 0, first_scan = 0;
    std::int64_t utime = 0, heard_utime = 0;  ///< Of the filters, and of their newest return [us].
    std::array<Filter, kFilters> filters;
  };

  Bank& bank_of(const TargetTrack& track, std::int64_t utime);
  void begin(const TargetTrack& track, std::int64_t utime, Bank& bank) const;
  void predict(double seconds, Bank& bank) const;
  std::optional<std::size_t> own_return(const Bank& bank, const ScanTable& scan, const BeamMask* mask) const;
  void update(const core::Detection& detection, Bank& bank);
  Eigen::Matrix2d error_of(const core::Detection& detection, double factor) const;
  void learn(const std::array<double, kFilters>& foretold);
  static double prior(std::size_t filter);

  core::SonarParams sonar_;
  std::array<double, kRates> rates_{};        ///< [m/s per root second], the first 0.
  std::array<double, kFilters> posterior_{};  ///< Probabilities of errors and rate.
  std::vector<Bank> banks_;
};

}  // namespace lookout::csht
