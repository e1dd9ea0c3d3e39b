#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tools {

/// Time since the first ping, of a sonar whose clock begins again after a while: the count of the pings tells
/// how often it did so between two of them, at the rate that the sonar had.
class WrappedClock {
 public:
  /// @param number of the ping, counted in 32 bits. @param start on the sonar's clock [s].
  /// @param wrap after which that begins again at 0 [s]; 0: it does not.
  /// @return time since the first ping [s]; never falls.
  double add(std::uint32_t number, double start, double wrap);

  std::int64_t restarts() const {
    return restarts_;
  }  ///< Times that the count went back: how long it took is unknown.

 private:
  double step_of(std::uint32_t pings, double start, double wrap) const;

  struct Ping {
    std::uint32_t number;
    double start;
  };
  std::optional<Ping> last_;
  double elapsed_ = 0.0;
  std::optional<double> period_;  ///< Of the pings, as of the last step [s].
  std::int64_t restarts_ = 0;
};

}  // namespace lookout::tools
