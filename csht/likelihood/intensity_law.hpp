#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// How the law of intensities is learnt.
struct IntensityLawParams {
  bool enabled = true;        ///< Without it an intensity tells nothing.
  int classes = 8;            ///< Of intensity, half of them by what targets return, 2 to 64 and even.
  int target_returns = 256;   ///< The latest of targets that are kept, >= `classes`.
  int false_returns = 1024;   ///< The latest of clutter that are kept, >= `classes`.
  int most_of_scan = 64;      ///< False returns taken of a scan, >= 1: of more, evenly spaced ones.
  double prior_returns = 16;  ///< Returns that the belief in one law for all weighs, > 0.
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const IntensityLawParams& params);

/// What the intensity of a return tells of its origin: how often targets, the uniform background and what is
/// dense bring it, learnt as shares of a few classes. Quantiles of what was heard part the classes, so that
/// the unit of the intensities does not matter; where all are equal there is one class, which tells nothing.
/// docs/clutter_map.md.
class IntensityLaw {
 public:
  /// @param params validated. Makes all buffers at once.
  explicit IntensityLaw(const IntensityLawParams& params);

  /// Takes the returns of a scan in, and learns the law anew where a quarter more of targets were heard than
  /// the last time, or as many as are kept. @param own probability, for each detection, that a sure target
  /// made it. @param likely the same of any likely target: what is neither is false.
  void take(const ScanTable& scan, std::span<const double> own, std::span<const double> likely);

  /// Density of an intensity among the returns of targets over that among false ones, of which `background`
  /// is the uniform background's share, in (0, 1]. 1 where nothing is known yet.
  double loudness(double intensity, double background) const;
  /// Writes that of each return of a scan to `loudness`, both laid out as ScanTable::background.
  void rate(const ScanTable& scan, std::span<const float> background, std::vector<float>& loudness) const;

  bool known() const { return !of_target_.empty(); }  ///< Whether a law was learnt.

 private:
  struct Heard {
    double intensity = 0.0;
    double weight = 1.0;      // Probability that it is what it is kept as.
    double background = 1.0;  // The uniform background's share of false returns there.
  };
  // The latest of its kind.
  struct Kept {
    std::vector<Heard> heard;
    std::size_t next = 0;  // The oldest, once there are as many as are kept.
    void take(const Heard& one, int most);
  };
  void learn();
  void find_edges();
  void add_quantiles(const Kept& kept);
  std::size_t class_of(double intensity) const;
  // What is believed of the classes, with the weight of so many returns.
  struct Prior {
    std::span<const double> shares;
    double returns = 0.0;
  };
  template <class Weight>
  void count(const Kept& kept, const Prior& prior, const Weight& weight, std::vector<double>& shares) const;

  IntensityLawParams params_;
  Kept targets_, clutter_;
  double heard_ = 0.0;          // Returns of targets so far,
  double needed_;               // and from how many on the law is learnt the next time.
  std::vector<double> edges_;   // Largest intensity of all classes but the last.
  std::vector<double> common_;  // Share of each class, targets and clutter alike,
  std::vector<double> of_target_, of_background_, of_dense_;  // and of either; empty: not known.
  std::vector<double> sorted_;
};

}  // namespace lookout::csht
