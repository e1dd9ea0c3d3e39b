#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/files/yaml_reader.hpp"

namespace lookout::core {

/// Values of parameters by path, such as "birth.seeds"; flags as 0 and 1.
using ParameterValues = std::map<std::string, double>;

/// What a parameter accepts: from `low` to `high`, either without the end itself where it is open.
struct Accepted {
  double low = -std::numeric_limits<double>::infinity();  ///< Least value.
  double high = std::numeric_limits<double>::infinity();  ///< Greatest value.
  bool open_low = false;                                  ///< Whether `low` itself is refused.
  bool open_high = false;                                 ///< Whether `high` itself is refused.

  bool holds(double value) const;  ///< Whether it accepts a value; NaN it does not.
  std::string text() const;        ///< "in (0, 1]", "> 0", ">= 1" or "any number".
};

/// One number or flag of a struct of parameters.
struct Parameter {
  std::string path;  ///< Names of the structs that hold it and its own, with points between.
  std::variant<double*, int*, bool*, std::optional<int>*> value;  ///< In the struct that was listed.
  Accepted accepted;                                              ///< Of a flag: nothing is checked.
  std::string meaning;                                            ///< Its docstring.

  std::string kind() const;     ///< "number", "whole number" or "true or false".
  std::string present() const;  ///< Its value as a configuration would say it; "absent" of an empty one.
  std::optional<double> number() const;  ///< Its value, a flag as 0 or 1; nothing of an empty one.
};

/// The parameters of a struct by path, so that a configuration, a sweep and a reference page know them all.
/// Filled by the `list_fields` functions that cmake/parameter_fields.py makes of the structs' headers. Points
/// into the struct, which must outlive it.
class ParameterList {
 public:
  /// Adds a number, flag or optional whole number.
  template <typename Value>
  void add(const std::string& path, Value& value, const Accepted& accepted, const std::string& meaning) {
    parameters_.push_back({path, &value, accepted, meaning});
  }

  const std::vector<Parameter>& all() const { return parameters_; }  ///< In the order of the structs.

  bool has(const std::string& path) const;  ///< Whether there is a parameter of this path.

  /// Sets a parameter. @throws InputError on an unknown path, which lists those of the same struct, on a
  /// value that is not accepted, and on a number that should be whole.
  void set(const std::string& path, double value);
  void set(const ParameterValues& values);  ///< All of them. @throws InputError as for one.

  /// Reads a mapping with the structs nested in it, and calls finish on each. Sets nothing.
  /// @throws InputError naming line, column and key: not known, of another kind or not accepted.
  ParameterValues read(const YamlMap& map) const;

 private:
  void read(const YamlMap& map, const std::string& prefix, ParameterValues& values) const;
  Parameter& find(const std::string& path);

  std::vector<Parameter> parameters_;
};

}  // namespace lookout::core
