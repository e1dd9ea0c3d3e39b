#include "core/yaml_reader.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/input_error.hpp"

namespace lookout::core {
namespace {

std::string where(const std::string& file, const YAML::Mark& mark) {
  if (mark.is_null()) return file;
  return file + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1);
}

std::string describe(const Range& range) {
  std::ostringstream text;
  if (range.min == kAnyNumber.min && range.max == kAnyNumber.max) return "a finite number";
  text << "a number";
  if (range.min > kAnyNumber.min) text << (range.open_min ? " > " : " >= ") << range.min;
  if (range.max < kAnyNumber.max) text << " <= " << range.max;
  return text.str();
}

bool contains(const Range& range, double value) {
  return std::isfinite(value) && value <= range.max &&
         (range.open_min ? value > range.min : value >= range.min);
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const auto& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

struct YamlMap::Impl {
  YAML::Node node;
  std::string file;
  mutable std::vector<std::string> accepted;

  /// The value of `key`, remembered as accepted. A const lookup: operator[] of a mutable node would insert.
  YAML::Node find(const std::string& key) const {
    if (std::find(accepted.begin(), accepted.end(), key) == accepted.end()) accepted.push_back(key);
    const YAML::Node& constant = node;
    return constant[key];
  }
};

YamlMap::YamlMap(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

YamlMap YamlMap::load_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; expected a YAML file");
  std::ostringstream text;
  text << file.rdbuf();
  return load_text(text.str(), path);
}

YamlMap YamlMap::load_text(const std::string& text, const std::string& name) {
  YAML::Node node;
  try {
    node = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw InputError(where(name, error.mark) + ": not valid YAML: " + error.msg);
  }
  if (node.IsNull()) node = YAML::Node(YAML::NodeType::Map);
  if (!node.IsMap()) throw InputError(where(name, node.Mark()) + ": expected a mapping of `key: value`");
  auto impl = std::make_shared<Impl>();
  impl->node.reset(node);
  impl->file = name;
  for (auto a = node.begin(); a != node.end(); ++a) {
    for (auto b = node.begin(); b != a; ++b) {
      if (a->first.Scalar() == b->first.Scalar())
        throw InputError(where(name, a->first.Mark()) + ": key `" + a->first.Scalar() + "` is given twice");
    }
  }
  return YamlMap(std::move(impl));
}

void YamlMap::fail(const std::string& key, const std::string& message) const {
  const YAML::Node value = impl_->find(key);
  throw InputError(where(impl_->file, value ? value.Mark() : impl_->node.Mark()) + ": " + key + ": " +
                   message);
}

bool YamlMap::has(const std::string& key) const {
  return static_cast<bool>(impl_->find(key));
}

std::optional<double> YamlMap::optional_number(const std::string& key, const Range& range) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return std::nullopt;
  double number = 0.0;
  if (!value.IsScalar() || !YAML::convert<double>::decode(value, number) || !contains(range, number))
    fail(key, "got `" + (value.IsScalar() ? value.Scalar() : "a list or mapping") + "`, expected " +
                  describe(range));
  return number;
}

double YamlMap::number(const std::string& key, double fallback, const Range& range) const {
  return optional_number(key, range).value_or(fallback);
}

double YamlMap::required_number(const std::string& key, const Range& range) const {
  const auto value = optional_number(key, range);
  if (!value) fail(key, "is missing, expected " + describe(range));
  return *value;
}

int YamlMap::integer(const std::string& key, int fallback, const Range& range) const {
  const auto value = optional_number(key, range);
  if (!value) return fallback;
  if (*value != std::floor(*value) || std::abs(*value) > 1e9)
    fail(key, "got `" + impl_->find(key).Scalar() + "`, expected a whole number");
  return static_cast<int>(*value);
}

bool YamlMap::flag(const std::string& key, bool fallback) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return fallback;
  bool result = false;
  if (!value.IsScalar() || !YAML::convert<bool>::decode(value, result)) fail(key, "expected true or false");
  return result;
}

std::string YamlMap::text(const std::string& key, const std::string& fallback) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return fallback;
  if (!value.IsScalar()) fail(key, "expected text");
  return value.Scalar();
}

std::string YamlMap::choice(const std::string& key, const std::string& fallback,
                            const std::vector<std::string>& accepted) const {
  std::string value = text(key, fallback);
  if (std::find(accepted.begin(), accepted.end(), value) == accepted.end() && has(key))
    fail(key, "got `" + value + "`, expected one of: " + joined(accepted));
  return value;
}

std::vector<double> YamlMap::numbers(const std::string& key) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return {};
  if (!value.IsSequence()) fail(key, "expected a list of numbers");
  std::vector<double> result;
  for (const auto& element : value) {
    double number = 0.0;
    if (!element.IsScalar() || !YAML::convert<double>::decode(element, number) || !std::isfinite(number))
      fail(key, "expected a list of finite numbers");
    result.push_back(number);
  }
  return result;
}

std::optional<YamlMap> YamlMap::map(const std::string& key) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return std::nullopt;
  if (!value.IsMap()) fail(key, "expected a mapping of `key: value`");
  auto impl = std::make_shared<Impl>();
  impl->node.reset(value);
  impl->file = impl_->file;
  return YamlMap(std::move(impl));
}

std::vector<YamlMap> YamlMap::maps(const std::string& key) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return {};
  if (!value.IsSequence()) fail(key, "expected a list of mappings");
  std::vector<YamlMap> result;
  for (const auto& element : value) {
    if (!element.IsMap()) fail(key, "expected a list of mappings");
    auto impl = std::make_shared<Impl>();
    impl->node.reset(element);
    impl->file = impl_->file;
    result.push_back(YamlMap(std::move(impl)));
  }
  return result;
}

void YamlMap::finish() const {
  for (const auto& entry : impl_->node) {
    const std::string& key = entry.first.Scalar();
    if (std::find(impl_->accepted.begin(), impl_->accepted.end(), key) != impl_->accepted.end()) continue;
    throw InputError(where(impl_->file, entry.first.Mark()) + ": unknown key `" + key +
                     "`, accepted: " + joined(impl_->accepted));
  }
}

}  // namespace lookout::core
