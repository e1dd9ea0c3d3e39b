#pragma once

#include <cstdint>
#include <limits>
#include <memory>

namespace lookout::core {

/// The purposes that draw, so that no two of them share a stream of random numbers.
enum class RandomStream : std::uint32_t {
  simulator = 1,
  tracker = 2,
  estimator = 3,
  experiment = 4,
  images = 5
};

/// A seeded generator (MRPT's Mersenne twister) that is handed to whatever draws. Also a standard
/// UniformRandomBitGenerator.
class Random {
 public:
  using result_type = std::uint32_t;

  explicit Random(std::uint64_t seed);  ///< A generator of this seed alone, in no stream.
  /// The generator of one (seed, stream, index): run k of an experiment, scan k of a tracker.
  Random(std::uint64_t seed, RandomStream stream, std::uint64_t index = 0);
  ~Random();
  Random(Random&&) noexcept;
  Random& operator=(Random&&) noexcept;

  double uniform(double low, double high);  ///< Uniform in [low, high).
  double gaussian(double sigma = 1.0);      ///< Zero mean, standard deviation `sigma` >= 0.
  bool bernoulli(double probability);       ///< True with `probability`.
  int poisson(double mean);                 ///< Poisson number, mean >= 0.
  int index(int size);                      ///< Uniform in 0 .. size - 1, size > 0.

  /// Starts the stream of (seed, stream, index) again without allocating.
  void reseed(std::uint64_t seed, RandomStream stream, std::uint64_t index);

  result_type operator()();
  static constexpr result_type min() { return 0; }  ///< Least value of `operator()`.
  /// Greatest value of `operator()`.
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lookout::core
