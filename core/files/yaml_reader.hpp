#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lookout::core {

/// Which numbers a key accepts; both ends included unless `open_min` says that the lower one is not.
struct Range {
  double min = -std::numeric_limits<double>::infinity();  ///< Least value.
  double max = std::numeric_limits<double>::infinity();   ///< Greatest value.
  bool open_min = false;                                  ///< Whether `min` itself is refused.
};

inline constexpr Range kAnyNumber{};  ///< Every finite number.
inline constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};  ///< Above 0.
inline constexpr Range kNotNegative{0.0};                                              ///< 0 or above.
inline constexpr Range kProbability{0.0, 1.0};                                         ///< From 0 to 1.

/// A YAML mapping read strictly: the keys that are asked for are the keys that are accepted, and `finish`
/// refuses the rest. Every error is an InputError that names file, line, column and key, and says what is
/// accepted.
class YamlMap {
 public:
  /// @throws InputError where the file cannot be read, is not YAML or is not a mapping.
  static YamlMap load_file(const std::string& path);
  /// The same from text; `name` stands for the file in messages.
  static YamlMap load_text(const std::string& text, const std::string& name);

  bool has(const std::string& key) const;  ///< Counts the key as accepted.

  /// The value of `key`, or `fallback` where it is absent.
  /// @throws InputError on a value of another kind, not finite or out of range.
  double number(const std::string& key, double fallback, const Range& range = kAnyNumber) const;
  /// The value of `key`; nothing where it is absent. @throws InputError as `number`.
  std::optional<double> optional_number(const std::string& key, const Range& range = kAnyNumber) const;
  /// The value of `key`. @throws InputError as `number`, and where it is absent.
  double required_number(const std::string& key, const Range& range = kAnyNumber) const;
  /// The value of `key` as a whole number, or `fallback`. @throws InputError as `number`.
  int integer(const std::string& key, int fallback, const Range& range = kAnyNumber) const;
  /// The value of `key`, true or false, or `fallback`. @throws InputError on anything else.
  bool flag(const std::string& key, bool fallback) const;
  /// The value of `key` as it stands, or `fallback`. @throws InputError on a list or a mapping.
  std::string text(const std::string& key, const std::string& fallback) const;
  /// One of `accepted`.
  std::string choice(const std::string& key, const std::string& fallback,
                     const std::vector<std::string>& accepted) const;
  std::vector<double> numbers(const std::string& key) const;  ///< Empty where absent.

  std::optional<YamlMap> map(const std::string& key) const;  ///< Nothing where absent.
  std::vector<YamlMap> maps(const std::string& key) const;   ///< A sequence of mappings; empty where absent.

  /// @throws InputError naming the first key that nothing asked for, and those that are accepted.
  void finish() const;

  /// An InputError at `key` (at the mapping itself where the key is absent).
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Impl;
  explicit YamlMap(std::shared_ptr<Impl> impl);
  std::shared_ptr<Impl> impl_;
};

}  // namespace lookout::core
