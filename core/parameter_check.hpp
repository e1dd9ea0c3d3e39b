#pragma once

#include <string_view>

namespace lookout::core {

/// Checks a parameter at construction.
/// @param rule names the parameter and what is accepted: "rho_step must be > 0".
/// @throws std::invalid_argument `RULE, got VALUE` unless `holds`.
void require(bool holds, std::string_view rule, double value);

/// @throws std::invalid_argument `NAME must be > 0 and finite, got VALUE` unless it is.
void require_positive(std::string_view name, double value);

/// @throws std::invalid_argument `NAME must be >= 0, got VALUE` unless it is.
void require_not_negative(std::string_view name, double value);

/// @throws std::invalid_argument `NAME must be in [0, 1], got VALUE` unless it is.
void require_probability(std::string_view name, double value);

/// @throws std::invalid_argument `NAME must be in (0, 1), got VALUE` unless it is.
void require_inner_share(std::string_view name, double value);

/// @throws std::invalid_argument `NAME must be in (0, 1], got VALUE` unless it is.
void require_share(std::string_view name, double value);

/// @throws std::invalid_argument `NAME must be in [0, 1), got VALUE` unless it is.
void require_share_below_one(std::string_view name, double value);

}  // namespace lookout::core
