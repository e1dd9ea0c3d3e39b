#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

/// JSON as Python writes it: NaN, Infinity and numbers beyond a double, which JSON itself does not have.
namespace lookout::tools {

/// @param name of the text in messages.
/// @throws core::InputError `NAME:LINE:COLUMN: not JSON`.
nlohmann::json parse_lenient(std::string text, const std::string& name);

/// A number of what `parse_lenient` gave, NaN where the text had one that is not finite; nothing where it is
/// no number.
std::optional<double> lenient_number(const nlohmann::json& value);

}  // namespace lookout::tools
