#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/random.hpp"

namespace lookout::csht {

/// Draws from standard multivariate t distributions, made once and read from a random place on. Importance
/// sampling needs heavy tails, lest a trajectory that matters is hardly ever proposed ([Cappe2004] Sec. 2);
/// that each round makes new draws it does not need.
class ProposalPool {
 public:
  static constexpr std::size_t kLeastDimensions = 4;  ///< Fewest components that a proposal takes of a draw,
  static constexpr std::size_t kDimensions = 6;       ///< and most.

  /// One draw with its densities.
  struct Draw {
    std::array<double, kDimensions> z;  ///< Its first d components are a t draw in d dimensions.
    std::array<double, 3> log_density;  ///< ln of the density of the first four, five and six.
  };

  /// @param freedom degrees of freedom, > 2.
  /// @param size number of draws kept, a power of two.
  ProposalPool(double freedom, std::size_t size, core::Random& random);

  /// Draw `index` after a `start` that the caller takes at random; wraps around.
  const Draw& at(std::size_t start, std::size_t index) const { return draws_[(start + index) & mask_]; }
  std::size_t size() const { return draws_.size(); }  ///< Draws that are kept.

  /// ln of the density of the first `dimensions`, 4 to 6, components of a draw.
  static double log_density(const Draw& draw, int dimensions) {
    return draw.log_density[static_cast<std::size_t>(dimensions) - kLeastDimensions];
  }

 private:
  std::size_t mask_;
  std::vector<Draw> draws_;
};

}  // namespace lookout::csht
