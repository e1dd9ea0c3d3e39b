#include "tracking/initiation/initiator_registry.hpp"

#include <utility>

#include "core/name_table.hpp"
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
#include "tracking/tracker_registry.hpp"

namespace lookout::tracking {
namespace {

using KeyNames = std::initializer_list<const char*>;

/// Of every initiator on points: their accuracy, and the motion of the tracks that it follows.
constexpr KeyNames kPointKeys{"position_sigma", "range_sigma", "azimuth_sigma_deg", "acceleration_sigma"};

/// Of every birth method: the proof of what it proposes.
constexpr KeyNames kBirthKeys{"min_speed", "max_speed",        "acceleration_sigma",
                              "min_plots", "max_false_tracks", "clutter_per_area"};

/// Of those that are shown the surroundings of each plot (LocalInitiator): how far these reach.
constexpr KeyNames kLocalKeys{"gate_margin"};

struct Entry {
  std::string name;
  MakeInitiator make;
  std::vector<InitiatorKey> keys;
};

void append(std::vector<InitiatorKey>& keys, KeyNames names) {
  for (const char* name : names) keys.push_back({.name = name});
}

Entry entry_of(const char* name, MakeInitiator make, KeyNames names) {
  Entry entry{name, std::move(make), {}};
  append(entry.keys, names);
  return entry;
}

/// One line an initiator; those from outside follow.
core::NameTable<Entry>& registry() {
  static core::NameTable<Entry> entries(
      "initiator", {
                       entry_of("ht", &make_ht, kLineVotingKeys),
                       entry_of("mht_ti", &make_mht_ti, kLineVotingKeys),
                       entry_of("iht_ti", &make_iht_ti, kIhtTiKeys),
                       entry_of("nht_ti", &make_nht_ti, kNhtTiKeys),
                       entry_of("ag_fht", &make_ag_fht, kAgFhtKeys),
                       entry_of("modified_logic", &make_modified_logic, kModifiedLogicKeys),
                       entry_of("modified_ht", &make_modified_ht, kModifiedHtKeys),
                       entry_of("sequence_ht", &make_sequence_ht, kSequenceHtKeys),
                       entry_of("fpht", &make_fpht, kFphtKeys),
                       entry_of("nht_plus", &make_nht_plus, kNhtPlusKeys),
                       entry_of("vct", &make_vct, kVctKeys),
                   });
  return entries;
}

/// The keys that are accepted for one initiator; where there is none of that name, those of all.
std::vector<InitiatorKey> accepted_keys(const std::string& name, InitiatorUse use) {
  std::vector<InitiatorKey> keys;
  append(keys, use == InitiatorUse::points ? kPointKeys : kBirthKeys);
  if (use == InitiatorUse::births && !suits_any_sensor(name)) append(keys, kLocalKeys);
  if (const Entry* entry = registry().find(name)) {
    keys.insert(keys.end(), entry->keys.begin(), entry->keys.end());
    return keys;
  }
  for (const Entry& entry : registry().entries())
    keys.insert(keys.end(), entry.keys.begin(), entry.keys.end());
  for (const auto& key : common_initiator_keys()) keys.push_back({.name = key});
  return keys;
}

}  // namespace

bool suits_any_sensor(const std::string& name) {
  return name == "vct";
}

void register_initiator(const std::string& name, MakeInitiator make, std::vector<InitiatorKey> keys) {
  // A tracker's name as birth method means the tracker's own births.
  registry().add({name, std::move(make), std::move(keys)}, tracker_names());
}

void read_initiator_config(const core::YamlMap& map, const std::string& name, InitiatorUse use,
                           InitiatorConfig& config) {
  read_initiator_config(map, accepted_keys(name, use), config);
}

std::vector<std::string> initiator_names() {
  return registry().names();
}

std::unique_ptr<Initiator> make_initiator(const std::string& name, const InitiatorConfig& config) {
  return registry().at(name).make(config);
}

}  // namespace lookout::tracking
