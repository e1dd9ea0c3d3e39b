#include "tools/fault/fault_stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/frames.hpp"
#include "tools/fault/spoiled_content.hpp"

namespace lookout::tools {

FaultStage::FaultStage(const Fault& fault, core::Random random) : fault_(fault), random_(std::move(random)) {}

bool FaultStage::concerns(Stream stream) const {
  return std::find(fault_.streams.begin(), fault_.streams.end(), stream) != fault_.streams.end();
}

const FaultFigures& FaultStage::figures(Stream stream) const {
  return figures_.at(static_cast<std::size_t>(stream));
}

FaultFigures& FaultStage::of(Stream stream) {
  return figures_.at(static_cast<std::size_t>(stream));
}

void FaultStage::take(FaultMessage message, double elapsed, const Pass& pass) {
  release(elapsed, pass);
  if (!concerns(message.stream)) return pass(std::move(message));
  if (fault_.kind == FaultKind::slow) renumber(message);
  if (at_work(elapsed)) return spoil(std::move(message), elapsed, pass);
  const Stream stream = message.stream;
  pass(std::move(message));
  if (auto waiting = swapped_.extract(stream)) pass(std::move(waiting.mapped()));
}

void FaultStage::finish(const Pass& pass) {
  release(std::numeric_limits<double>::infinity(), pass);
  for (auto& [stream, message] : std::exchange(swapped_, {})) pass(std::move(message));
}

void FaultStage::release(double elapsed, const Pass& pass) {
  while (!held_.empty() && held_.front().due <= elapsed) {
    FaultMessage message = std::move(held_.front().message);
    held_.pop_front();
    pass(std::move(message));
  }
}

void FaultStage::hold(FaultMessage message, double due) {
  held_.push_back({due, std::move(message)});  // One delay for all: the order of arrival is that of `due`.
}

void FaultStage::spoil(FaultMessage message, double elapsed, const Pass& pass) {
  FaultFigures& figures = of(message.stream);
  ++seen_[message.stream];
  if (!passes(message, elapsed)) {
    ++figures.withheld;
    return;
  }
  if (is_late(message, elapsed)) {
    ++figures.late;
    return;
  }
  change(message, elapsed);
  add_beside(message, elapsed, pass);
  const Stream stream = message.stream;
  pass(std::move(message));
  if (auto waiting = swapped_.extract(stream)) pass(std::move(waiting.mapped()));
}

bool FaultStage::passes(const FaultMessage& message, double elapsed) {
  switch (fault_.kind) {
    case FaultKind::off:
      return false;
    case FaultKind::lost:
      return !random_.bernoulli(fault_.share);
    case FaultKind::intermittent:
      return std::fmod(elapsed - fault_.from, fault_.off + fault_.on) >= fault_.off;
    case FaultKind::slow:
      if ((seen_[message.stream] - 1) % fault_.keep_every == 0) return true;
      if (message.stream == Stream::scan) ++skipped_;
      return false;
    default:
      return true;
  }
}

/// Whether the message is kept for later.
bool FaultStage::is_late(FaultMessage& message, double elapsed) {
  if (fault_.kind == FaultKind::delayed) {
    hold(std::move(message), elapsed + fault_.delay);
    return true;
  }
  if (fault_.kind != FaultKind::reordered || swapped_.contains(message.stream) ||
      !random_.bernoulli(fault_.share))
    return false;
  const Stream stream = message.stream;
  swapped_.emplace(stream, std::move(message));
  return true;
}

void FaultStage::change(FaultMessage& message, double elapsed) {
  const bool was_changed = std::exchange(message.changed, false);
  switch (fault_.kind) {
    case FaultKind::stuck:
      freeze(message, frozen_.try_emplace(message.stream, message.content).first->second);
      break;
    case FaultKind::garbage:
      become_garbage(message);
      break;
    case FaultKind::wrong:
      falsify(message, fault_.wrongness, fault_.factor);
      break;
    case FaultKind::clock_step:
      shift_time(message, core::microseconds(fault_.step));
      break;
    case FaultKind::clock_drift:
      shift_time(message, core::microseconds(fault_.rate * (elapsed - fault_.from)));
      break;
    case FaultKind::sequence_jump:
      shift_sequence(message, fault_.jump);
      break;
    default:
      break;
  }
  if (message.changed) ++of(message.stream).changed;
  message.changed = message.changed || was_changed;
}

void FaultStage::become_garbage(FaultMessage& message) {
  if (random_.bernoulli(fault_.share)) message = garbage_like(message, random_);
}

/// A sender that works less often counts what it sends, for ever after.
void FaultStage::renumber(FaultMessage& message) {
  if (skipped_ > 0) shift_sequence(message, -skipped_);
}

void FaultStage::add_beside(const FaultMessage& message, double elapsed, const Pass& pass) {
  FaultFigures& figures = of(message.stream);
  if (fault_.kind == FaultKind::doubled && random_.bernoulli(fault_.share)) {
    ++figures.added;
    pass(message);
  }
  for (int copy = 0; copy < fault_.copies; ++copy) {
    ++figures.added;
    pass(fault_.copies_are_garbage ? garbage_like(message, random_) : message);
  }
  if (fault_.kind == FaultKind::two_sources) add_second_source(message, elapsed);
}

/// The other sender sees the mirror image, `shift` later, and numbers its own.
void FaultStage::add_second_source(const FaultMessage& message, double elapsed) {
  FaultMessage second = message;
  falsify(second, Wrongness::mirrored, 1.0);
  shift_time(second, core::microseconds(fault_.shift));
  if (auto* scan = std::get_if<core::SonarScan>(&second.content)) scan->sequence = second_sequence_++;
  if (!second.changed) return;
  ++of(message.stream).added;
  hold(std::move(second), elapsed + fault_.shift);
}

}  // namespace lookout::tools
