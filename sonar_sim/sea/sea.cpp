#include "sonar_sim/sea/sea.hpp"

namespace lookout::sonar_sim {
namespace {

void append(std::vector<BeamReturn>& all, const std::vector<BeamReturn>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// The plan with its random places fixed: the same for every sonar of a run.
SeaPlan placed(SeaPlan plan, const StreamKey& key) {
  core::Random places = open_stream(key.of_the_run(), StreamPurpose::places);
  plan.standing = place_fields(std::move(plan.standing), places);
  return plan;
}

}  // namespace

Sea::Sea(const SeaPlan& plan, const StreamKey& key)
    : plan_(placed(plan, key)),
      tails_random_(open_stream(key, StreamPurpose::heavy_tails)),
      spill_random_(open_stream(key, StreamPurpose::spill)),
      standing_random_(open_stream(key, StreamPurpose::standing)),
      patches_random_(open_stream(key, StreamPurpose::patches)),
      bottom_random_(open_stream(key, StreamPurpose::bottom)),
      intensity_random_(open_stream(key, StreamPurpose::intensity)),
      loss_random_(open_stream(key, StreamPurpose::scan_loss)) {
  if (plan_.fluctuation) fluctuation_.emplace(*plan_.fluctuation);
}

void Sea::change_targets(const Ping& ping, const core::GroundTruth& truth, std::vector<BeamTarget>& targets) {
  if (plan_.echo_probability) weaken(*plan_.echo_probability, ping, truth, targets);
  if (plan_.heavy_tails) widen(*plan_.heavy_tails, targets, tails_random_);
}

void Sea::add_returns(const Ping& ping, std::vector<BeamReturn>& heard) {
  append(heard, draw_standing(plan_.standing, ping, standing_random_));
  if (plan_.spill) append(heard, draw_spill(*plan_.spill, ping, heard, spill_random_));
  for (const auto& patch : plan_.patches) append(heard, draw_patch(patch, ping, patches_random_));
  if (plan_.bottom) append(heard, draw_bottom(*plan_.bottom, ping, bottom_random_));
}

void Sea::mark(std::vector<BeamReturn>& heard) {
  if (fluctuation_) fluctuation_->mark(heard, intensity_random_);
}

ScanFate Sea::draw_fate() {
  return plan_.scan_loss ? sonar_sim::draw_fate(*plan_.scan_loss, loss_random_) : ScanFate::whole;
}

}  // namespace lookout::sonar_sim
