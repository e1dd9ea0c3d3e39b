#include "tracking/initiation/initiator_registry.hpp"

#include <stdexcept>

#include "tracking/initiation/methods/ag_fht.hpp"
#include "tracking/initiation/methods/fpht.hpp"
#include "tracking/initiation/methods/ht.hpp"
#include "tracking/initiation/methods/iht_ti.hpp"
#include "tracking/initiation/methods/mht_ti.hpp"
#include "tracking/initiation/methods/modified_ht.hpp"
#include "tracking/initiation/methods/modified_logic.hpp"
#include "tracking/initiation/methods/nht_plus.hpp"
#include "tracking/initiation/methods/nht_ti.hpp"
#include "tracking/initiation/methods/sequence_ht.hpp"
#include "tracking/initiation/methods/vct.hpp"

namespace lookout::tracking {
namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Initiator> (*make)(const InitiatorConfig&);
};

/// One line an initiator.
constexpr Entry kRegistry[] = {
    {"ht", &make_ht},
    {"mht_ti", &make_mht_ti},
    {"iht_ti", &make_iht_ti},
    {"nht_ti", &make_nht_ti},
    {"ag_fht", &make_ag_fht},
    {"modified_logic", &make_modified_logic},
    {"modified_ht", &make_modified_ht},
    {"sequence_ht", &make_sequence_ht},
    {"fpht", &make_fpht},
    {"nht_plus", &make_nht_plus},
    {"vct", &make_vct},
};

}  // namespace

std::vector<std::string> initiator_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kRegistry) names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Initiator> make_initiator(const std::string& name, const InitiatorConfig& config) {
  std::string accepted;
  for (const Entry& entry : kRegistry) {
    if (name == entry.name) return entry.make(config);
    accepted += std::string(" ") + entry.name;
  }
  throw std::invalid_argument("initiator must be one of" + accepted + ", got `" + name + "`");
}

}  // namespace lookout::tracking
