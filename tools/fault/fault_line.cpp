#include "tools/fault/fault_line.hpp"

#include <algorithm>
#include <utility>

#include "core/frames.hpp"

namespace lookout::tools {
namespace {

/// Beyond the runs of any experiment, whose stream this is.
constexpr std::uint64_t kFirstIndex = std::uint64_t{1} << 40U;

}  // namespace

FaultLine::FaultLine(const FaultPlan& plan, std::uint64_t seed, FaultStage::Pass pass)
    : pass_(std::move(pass)) {
  for (const auto& fault : plan.faults)
    stages_.emplace_back(fault,
                         core::Random(seed, core::RandomStream::experiment, kFirstIndex + stages_.size()));
}

void FaultLine::take(FaultMessage message) {
  if (!first_utime_) first_utime_ = message.utime;
  elapsed_ = std::max(elapsed_, core::seconds(message.utime - *first_utime_));
  ++counts_[message.stream].taken;
  pass_on(0, std::move(message));
}

void FaultLine::pass_on(std::size_t stage, FaultMessage message) {
  if (stage < stages_.size())
    return stages_[stage].take(std::move(message), elapsed_,
                               [this, stage](FaultMessage next) { pass_on(stage + 1, std::move(next)); });
  ++counts_[message.stream].passed;
  pass_(std::move(message));
}

void FaultLine::finish() {
  for (std::size_t stage = 0; stage < stages_.size(); ++stage)
    stages_[stage].finish([this, stage](FaultMessage next) { pass_on(stage + 1, std::move(next)); });
}

FaultLine::Counts FaultLine::counts(Stream stream) const {
  const auto found = counts_.find(stream);
  Counts counts = found == counts_.end() ? Counts{} : found->second;
  for (const auto& stage : stages_) {
    const FaultFigures& figures = stage.figures(stream);
    counts.faults.withheld += figures.withheld;
    counts.faults.changed += figures.changed;
    counts.faults.added += figures.added;
    counts.faults.late += figures.late;
  }
  return counts;
}

}  // namespace lookout::tools
