#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/random.hpp"

namespace lookout::tracking {

/// Draws from standard multivariate t distributions, made once and used from a random place on: proposals of
/// importance sampling need cheap draws with heavy tails, not new ones.
class ProposalPool {
 public:
  static constexpr std::size_t kDimensions = 6;

  struct Draw {
    std::array<double, kDimensions> z;  ///< A t draw in any first d of its components.
    double log_density4 = 0.0;          ///< ln of the density of its first four components.
    double log_density6 = 0.0;          ///< ln of the density of all six.
  };

  /// @param freedom degrees of freedom, > 2.
  /// @param size number of draws kept, a power of two.
  ProposalPool(double freedom, std::size_t size, core::Random& random);

  /// Draw `index` after a `start` that the caller takes at random; wraps around.
  const Draw& at(std::size_t start, std::size_t index) const { return draws_[(start + index) & mask_]; }
  std::size_t size() const { return draws_.size(); }
  double freedom() const { return freedom_; }

  /// ln of the density in d = 4 or 6 dimensions at squared distance `square`.
  double log_density(double square, int dimensions) const;

 private:
  double freedom_;
  double log_norm4_, log_norm6_;
  std::size_t mask_;
  std::vector<Draw> draws_;
};

}  // namespace lookout::tracking
