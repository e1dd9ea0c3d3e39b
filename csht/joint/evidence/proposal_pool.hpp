#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/random.hpp"

namespace lookout::csht {

/// Draws from standard multivariate t distributions, made once and used from a random place on: proposals of
/// importance sampling need cheap draws with heavy tails, not new ones.
class ProposalPool {
 public:
  static constexpr std::size_t kLeastDimensions = 4, kDimensions = 6;

  struct Draw {
    std::array<double, kDimensions> z;  ///< A t draw in any first d of its components.
    std::array<double, 3> log_density;  ///< ln of the densities of its first four, five and six components.
  };

  /// @param freedom degrees of freedom, > 2.
  /// @param size number of draws kept, a power of two.
  ProposalPool(double freedom, std::size_t size, core::Random& random);

  /// Draw `index` after a `start` that the caller takes at random; wraps around.
  const Draw& at(std::size_t start, std::size_t index) const { return draws_[(start + index) & mask_]; }
  std::size_t size() const { return draws_.size(); }

  /// ln of the density of the first `dimensions`, 4 to 6, components of a draw.
  static double log_density(const Draw& draw, int dimensions) {
    return draw.log_density[static_cast<std::size_t>(dimensions) - kLeastDimensions];
  }

 private:
  std::size_t mask_;
  std::vector<Draw> draws_;
};

}  // namespace lookout::csht
