#include "core/parameter_check.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/files/csv.hpp"

namespace lookout::core {

void require(bool holds, std::string_view rule, double value) {
  if (!holds) throw std::invalid_argument(std::string(rule) + ", got " + shortest(value));
}

void require_positive(std::string_view name, double value) {
  if (!(value > 0.0 && std::isfinite(value)))
    require(false, std::string(name) + " must be > 0 and finite", value);
}

void require_not_negative(std::string_view name, double value) {
  if (!(value >= 0.0)) require(false, std::string(name) + " must be >= 0", value);
}

void require_probability(std::string_view name, double value) {
  if (!(value >= 0.0 && value <= 1.0)) require(false, std::string(name) + " must be in [0, 1]", value);
}

void require_inner_share(std::string_view name, double value) {
  if (!(value > 0.0 && value < 1.0)) require(false, std::string(name) + " must be in (0, 1)", value);
}

void require_share(std::string_view name, double value) {
  if (!(value > 0.0 && value <= 1.0)) require(false, std::string(name) + " must be in (0, 1]", value);
}

void require_share_below_one(std::string_view name, double value) {
  if (!(value >= 0.0 && value < 1.0)) require(false, std::string(name) + " must be in [0, 1)", value);
}

}  // namespace lookout::core
