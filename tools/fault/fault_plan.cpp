#include "tools/fault/fault_plan.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/files/yaml_reader.hpp"

namespace lookout::tools {
namespace {

using core::kPositive;
using core::Range;
using core::YamlMap;

constexpr std::array<std::pair<FaultKind, std::string_view>, 15> kKinds{
    {{FaultKind::off, "off"},
     {FaultKind::stuck, "stuck"},
     {FaultKind::garbage, "garbage"},
     {FaultKind::wrong, "wrong"},
     {FaultKind::slow, "slow"},
     {FaultKind::delayed, "delayed"},
     {FaultKind::intermittent, "intermittent"},
     {FaultKind::doubled, "doubled"},
     {FaultKind::reordered, "reordered"},
     {FaultKind::lost, "lost"},
     {FaultKind::clock_step, "clock_step"},
     {FaultKind::clock_drift, "clock_drift"},
     {FaultKind::sequence_jump, "sequence_jump"},
     {FaultKind::two_sources, "two_sources"},
     {FaultKind::flood, "flood"}}};

constexpr Range kShare{0.0, 1.0, true};
constexpr Range kSeconds{0.0, 3600.0, true};  // A relay keeps what it delays.
constexpr Range kClock{-1e8, 1e8};            // Some years [s]; what a clock may be off by.
constexpr Range kRate{-0.5, 0.5};             // [s/s]
constexpr Range kJump{-1e12, 1e12};
constexpr Range kEvery{2, 1000};
constexpr Range kCopies{1, 10'000};

FaultKind kind_of(const std::string& name) {
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& k) { return k.second == name; });
  return found->first;
}

/// A number that does nothing at 0.
double effective(const YamlMap& map, const std::string& key, const Range& range) {
  const double value = map.required_number(key, range);
  if (value == 0.0) map.fail(key, "is 0, so that the fault would do nothing");
  return value;
}

/// Kinds that look into the content, which a relay does not do with images.
bool reads_content(FaultKind kind) {
  constexpr std::array kReaders{FaultKind::stuck,      FaultKind::wrong,       FaultKind::slow,
                                FaultKind::clock_step, FaultKind::clock_drift, FaultKind::sequence_jump,
                                FaultKind::two_sources};
  return std::find(kReaders.begin(), kReaders.end(), kind) != kReaders.end();
}

void read_streams(const YamlMap& map, Fault& fault) {
  const bool numbered = fault.kind == FaultKind::sequence_jump;
  const auto accepted = numbered ? std::vector<std::string>{"scan"}
                        : reads_content(fault.kind)
                            ? std::vector<std::string>{"scan", "vehicle", "all"}
                            : std::vector<std::string>{"scan", "vehicle", "image", "all"};
  const std::string stream = map.choice("channel", "scan", accepted);
  if (stream == "vehicle" || stream == "all") fault.streams.push_back(Stream::vehicle);
  if (stream == "scan" || stream == "all") fault.streams.push_back(Stream::scan);
  if (stream == "image" || (stream == "all" && !reads_content(fault.kind)))
    fault.streams.push_back(Stream::image);
}

void read_wrong(const YamlMap& map, Fault& fault) {
  const std::string how = map.choice("how", "scale", {"scale", "degrees", "mirrored"});
  if (how == "degrees") fault.wrongness = Wrongness::degrees;
  if (how == "mirrored") fault.wrongness = Wrongness::mirrored;
  if (how == "scale") fault.factor = map.number("factor", fault.factor, kPositive);
}

void read_flood(const YamlMap& map, Fault& fault) {
  fault.copies = map.integer("copies", 100, kCopies);
  fault.copies_are_garbage = map.choice("content", "repeat", {"repeat", "garbage"}) == "garbage";
}

/// What is off by something; of other kinds nothing.
void read_offset(const YamlMap& map, Fault& fault) {
  if (fault.kind == FaultKind::clock_step) fault.step = effective(map, "step", kClock);
  if (fault.kind == FaultKind::clock_drift) fault.rate = effective(map, "rate", kRate);
  if (fault.kind == FaultKind::sequence_jump)
    fault.jump = static_cast<std::int64_t>(effective(map, "jump", kJump));
}

void read_numbers(const YamlMap& map, Fault& fault) {
  switch (fault.kind) {
    case FaultKind::garbage:
    case FaultKind::doubled:
    case FaultKind::reordered:
    case FaultKind::lost:
      fault.share = map.number("share", fault.share, kShare);
      break;
    case FaultKind::wrong:
      read_wrong(map, fault);
      break;
    case FaultKind::slow:
      fault.keep_every = map.integer("keep_every", fault.keep_every, kEvery);
      break;
    case FaultKind::delayed:
      fault.delay = map.required_number("delay", kSeconds);
      break;
    case FaultKind::intermittent:
      fault.off = map.required_number("off", kSeconds);
      fault.on = map.required_number("on", kSeconds);
      break;
    case FaultKind::two_sources:
      fault.shift = map.number("shift", fault.shift, kSeconds);
      break;
    case FaultKind::flood:
      read_flood(map, fault);
      break;
    default:
      read_offset(map, fault);
  }
}

Fault read_fault(const YamlMap& map) {
  Fault fault;
  if (!map.has("kind")) map.fail("kind", "is missing");
  fault.kind = kind_of(map.choice("kind", "", fault_kind_names()));
  read_streams(map, fault);
  fault.from = map.number("from", fault.from, core::kNotNegative);
  if (const auto to = map.optional_number("to", kPositive)) fault.to = *to;
  if (fault.to <= fault.from) map.fail("to", "expected a time after `from`");
  read_numbers(map, fault);
  map.finish();
  return fault;
}

FaultPlan read(const YamlMap& map) {
  FaultPlan plan;
  for (const auto& fault : map.maps("faults")) plan.faults.push_back(read_fault(fault));
  if (plan.faults.empty()) map.fail("faults", "expected a list with one fault or more");
  map.finish();
  return plan;
}

}  // namespace

std::vector<std::string> fault_kind_names() {
  std::vector<std::string> names;
  for (const auto& [kind, name] : kKinds) names.emplace_back(name);
  return names;
}

std::string_view name_of(FaultKind kind) {
  return std::find_if(kKinds.begin(), kKinds.end(), [kind](const auto& k) { return k.first == kind; })
      ->second;
}

FaultPlan load_fault_plan(const std::string& path) {
  return read(YamlMap::load_file(path));
}

FaultPlan read_fault_plan(const std::string& text, const std::string& name) {
  return read(YamlMap::load_text(text, name));
}

}  // namespace lookout::tools
