#include "core/files/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "core/files/text_file.hpp"
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

/// What yaml-cpp says, which may hold the letter that it stumbled over: a line's end, any byte.
std::string one_line(std::string text) {
  if (text == YAML::ErrorMsg::BAD_FILE) return "is nested too deep";  // That is all that it means by it here.
  for (char& letter : text)
    if (letter < ' ' || letter > '~') letter = '?';
  return text;
}

/// The first line, from 1, that a tab stands before: YAML has none there, and yaml-cpp names what follows.
std::optional<std::size_t> line_indented_by_a_tab(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = std::min(line.find_first_not_of(" \t\r"), line.size());
    if (line.find('\t') < first) return number;
  }
  return std::nullopt;
}

/// What a person wrote in place of a number.
std::string what_stands(const YAML::Node& value) {
  if (value.IsScalar()) return shown(value.Scalar());
  return value.IsNull() ? "nothing" : "a list or mapping";
}

constexpr const char* kMergeKey = "<<";
constexpr int kDeepest = 40;         // Levels of a configuration; an alias of itself has no end.
constexpr int kMostNodes = 200'000;  // An alias of an alias of an alias grows without a bound.

/// Resolves the merge keys of a document and refuses what YAML takes in silence: a key that stands twice in a
/// mapping, at any depth.
class Resolver {
 public:
  explicit Resolver(const std::string& file) : file_(file) {}

  void resolve(const YAML::Node& node, int depth = 0) {
    if (depth > kDeepest || ++nodes_ > kMostNodes) fail(node, "is nested too deep or refers to itself");
    if (node.IsSequence())
      for (const auto& element : node) resolve(element, depth + 1);
    if (!node.IsMap()) return;
    refuse_repeated_keys(node);
    for (const auto& entry : node) resolve(entry.second, depth + 1);
    if (const YAML::Node merged = node[kMergeKey]) merge(node, merged);
  }

  /// The mappings that were merged into others: their own keys need not be known ones.
  const std::vector<YAML::Node>& sources() const { return sources_; }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const {
    throw InputError(where(file_, node.Mark()) + ": " + message);
  }

  void refuse_repeated_keys(const YAML::Node& map) const {
    std::set<std::string> seen;
    for (const auto& entry : map) {
      if (!entry.first.IsScalar()) fail(entry.first, "a key is no plain text; expected `key: value`");
      if (!seen.insert(entry.first.Scalar()).second)
        fail(entry.first, "key " + shown(entry.first.Scalar()) + " is given twice");
    }
  }

  /// The keys of `merged` (a mapping, or a list of them) that `map` does not have itself.
  void merge(YAML::Node map, const YAML::Node& merged) {
    std::vector<YAML::Node> sources;
    if (merged.IsSequence())
      for (const auto& source : merged) sources.push_back(source);
    else
      sources.push_back(merged);
    map.remove(kMergeKey);
    for (const auto& source : sources) {
      if (!source.IsMap()) fail(merged, "<<: expected a mapping, by its *name, or a list of them");
      sources_.push_back(source);
      for (const auto& entry : source)
        if (!static_cast<const YAML::Node&>(map)[entry.first.Scalar()])
          map.force_insert(entry.first, entry.second);
    }
  }

  const std::string& file_;
  int nodes_ = 0;
  std::vector<YAML::Node> sources_;
};

/// Sees documents begin. yaml-cpp 0.7 does not get over some signs at the begin of one (`, a`): it gives
/// documents of nothing there, without an end.
class StandstillGuard : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == begin_) throw YAML::ParserException(mark, "a sign that cannot stand here");
    begin_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
  }
  void OnMapEnd() override {}

 private:
  int begin_ = -1;  ///< Of the document before, a place in the text.
};

/// @throws YAML::ParserException where reading the documents would have no end.
void require_an_end(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  StandstillGuard guard;
  while (parser.HandleNextDocument(guard)) {
  }
}

/// The only document of `text`.
YAML::Node only_document(const std::string& text, const std::string& name) {
  require_an_end(text);
  const std::vector<YAML::Node> documents = YAML::LoadAll(text);
  for (std::size_t i = 1; i < documents.size(); ++i) {
    if (!documents[i].IsNull())
      throw InputError(where(name, documents[i].Mark()) + ": a second document; expected one in the file");
  }
  return documents.empty() ? YAML::Node() : documents.front();
}

}  // namespace

struct YamlMap::Impl {
  YAML::Node node;
  std::string file;
  std::vector<YAML::Node> merge_sources;
  mutable std::vector<std::string> accepted;

  /// A mapping inside this one.
  std::shared_ptr<Impl> inner(const YAML::Node& map) const {
    auto impl = std::make_shared<Impl>();
    impl->node.reset(map);
    impl->file = file;
    impl->merge_sources = merge_sources;
    return impl;
  }

  bool is_merge_source(const YAML::Node& value) const {
    return std::any_of(merge_sources.begin(), merge_sources.end(),
                       [&value](const YAML::Node& source) { return source.is(value); });
  }

  /// The value of `key`, remembered as accepted. A const lookup: operator[] of a mutable node would insert.
  YAML::Node find(const std::string& key) const {
    if (std::find(accepted.begin(), accepted.end(), key) == accepted.end()) accepted.push_back(key);
    const YAML::Node& constant = node;
    return constant[key];
  }
};

YamlMap::YamlMap(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

YamlMap YamlMap::load_file(const std::string& path) {
  return load_text(read_text_file(path, "a YAML file"), path);
}

YamlMap YamlMap::load_text(const std::string& text, const std::string& name) {
  auto impl = std::make_shared<Impl>();
  impl->file = name;
  try {
    YAML::Node node = only_document(text, name);
    if (node.IsNull()) node = YAML::Node(YAML::NodeType::Map);
    if (!node.IsMap()) throw InputError(where(name, node.Mark()) + ": expected a mapping of `key: value`");
    Resolver resolver(impl->file);
    resolver.resolve(node);
    impl->node.reset(node);
    impl->merge_sources = resolver.sources();
  } catch (const YAML::Exception& error) {
    if (const auto line = line_indented_by_a_tab(text))
      throw InputError(name + ":" + std::to_string(*line) + ":1: a tab in the indentation, expected blanks");
    throw InputError(where(name, error.mark) + ": not valid YAML: " + one_line(error.msg));
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
    fail(key, "got " + what_stands(value) + ", expected " + describe(range));
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
    fail(key, "got " + shown(impl_->find(key).Scalar()) + ", expected a whole number");
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
    fail(key, "got " + shown(value) + ", expected one of: " + joined(accepted));
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
  return YamlMap(impl_->inner(value));
}

std::vector<YamlMap> YamlMap::maps(const std::string& key) const {
  const YAML::Node value = impl_->find(key);
  if (!value) return {};
  if (!value.IsSequence()) fail(key, "expected a list of mappings");
  std::vector<YamlMap> result;
  for (const auto& element : value) {
    if (!element.IsMap()) fail(key, "expected a list of mappings");
    result.push_back(YamlMap(impl_->inner(element)));
  }
  return result;
}

void YamlMap::finish() const {
  for (const auto& entry : impl_->node) {
    const std::string& key = entry.first.Scalar();
    if (std::find(impl_->accepted.begin(), impl_->accepted.end(), key) != impl_->accepted.end()) continue;
    if (impl_->is_merge_source(entry.second)) continue;
    throw InputError(where(impl_->file, entry.first.Mark()) + ": unknown key " + shown(key) +
                     ", accepted: " + joined(impl_->accepted));
  }
}

}  // namespace lookout::core
