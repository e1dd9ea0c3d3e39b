#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lookout::core {

/// @param kind of what is to be added under `name`, in the singular: "tracker".
/// @throws std::invalid_argument unless `name` is letters, digits and underscores, and none of `taken`.
void require_new_name(const std::string& kind, const std::string& name, std::span<const std::string> taken);

/// @throws std::invalid_argument always: `KIND must be one of A B C, got NAME`.
[[noreturn]] void refuse_name(const std::string& kind, std::string_view name,
                              std::span<const std::string> accepted);

/// What goes by name, in the order in which it is shown to a user. A table that a program adds to is the one
/// piece of global state: it only grows, is not guarded, and is meant to be filled at the start, before there
/// are threads.
/// @tparam Entry holds its `name`, and in `make` what makes the thing.
template <class Entry>
class NameTable {
 public:
  /// @param kind of the things, in the singular: "tracker".
  NameTable(std::string kind, std::vector<Entry> entries)
      : kind_(std::move(kind)), entries_(std::move(entries)) {}

  const std::vector<Entry>& entries() const { return entries_; }  ///< In their order.

  std::vector<std::string> names() const {  ///< Of the entries, in their order.
    std::vector<std::string> names;
    for (const Entry& entry : entries_) names.push_back(entry.name);
    return names;
  }

  /// Null where there is none of that name.
  const Entry* find(std::string_view name) const {
    const auto has_name = [&](const Entry& entry) { return entry.name == name; };
    const auto found = std::find_if(entries_.begin(), entries_.end(), has_name);
    return found == entries_.end() ? nullptr : &*found;
  }

  /// @throws std::invalid_argument on an unknown name, naming those that there are.
  const Entry& at(std::string_view name) const {
    const Entry* const found = find(name);
    if (found == nullptr) refuse_name(kind_, name, names());
    return *found;
  }

  /// Adds an entry behind the others.
  /// @param reserved names that are taken besides. @throws std::invalid_argument as `require_new_name`, and
  /// where `make` is empty.
  void add(Entry entry, const std::vector<std::string>& reserved = {}) {
    std::vector<std::string> taken = names();
    taken.insert(taken.end(), reserved.begin(), reserved.end());
    require_new_name(kind_, entry.name, taken);
    if (entry.make == nullptr)
      throw std::invalid_argument("the " + kind_ + " `" + entry.name + "` has no function that makes it");
    entries_.push_back(std::move(entry));
  }

 private:
  std::string kind_;
  std::vector<Entry> entries_;
};

}  // namespace lookout::core
