#include "core/name_table.hpp"

#include <cctype>

namespace lookout::core {
namespace {

bool is_name(const std::string& text) {
  const auto is_part = [](unsigned char letter) { return std::isalnum(letter) != 0 || letter == '_'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_part);
}

}  // namespace

void require_new_name(const std::string& kind, const std::string& name, std::span<const std::string> taken) {
  if (!is_name(name))
    throw std::invalid_argument("the name of the " + kind +
                                " must be letters, digits and underscores, got `" + name + "`");
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    throw std::invalid_argument("the " + kind + " `" + name + "` exists already, expected another name");
}

void refuse_name(const std::string& kind, std::string_view name, std::span<const std::string> accepted) {
  std::string names;
  for (const std::string& each : accepted) names += " " + each;
  throw std::invalid_argument(kind + " must be one of" + names + ", got `" + std::string(name) + "`");
}

}  // namespace lookout::core
