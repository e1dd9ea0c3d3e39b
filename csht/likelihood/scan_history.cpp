#include "csht/likelihood/scan_history.hpp"

#include <algorithm>
#include <cassert>

#include "core/parameter_check.hpp"

namespace lookout::csht {

ScanHistory::ScanHistory(const SensorFigures& figures, const SensorModelParams& model, int capacity)
    : figures_{figures}, empty_scans_(1), given_(figures), model_(model) {
  validate(figures);
  validate(model);
  core::require(capacity >= 1, "capacity must be >= 1", capacity);
  tables_.resize(static_cast<std::size_t>(capacity));
}

int ScanHistory::push(const core::PosedScan& scan, int sensor) {
  sensor_ = static_cast<std::size_t>(sensor);
  if (sensor_ >= figures_.size()) {
    figures_.resize(sensor_ + 1, given_);
    empty_scans_.resize(sensor_ + 1);
  }
  newest_ = (newest_ + 1) % capacity();
  size_ = std::min(size_ + 1, capacity());
  ++pushed_;
  make_room(scan.scan.returns.size(), static_cast<std::size_t>(scan.scan.num_beams) + 2);
  ScanTable& table = tables_[static_cast<std::size_t>(newest_)];
  const int left_out = fill_scan_table(scan, table);
  table.sensor = sensor;
  table.listened = static_cast<float>(empty_scans_[sensor_].take(table.detections.size()));
  rewrite(table);
  return left_out;
}

// All tables take the densest scan so far, so that none grows later.
void ScanHistory::make_room(std::size_t returns, std::size_t slots) {
  if (returns <= densest_ && slots <= widest_) return;
  densest_ = std::max(densest_, returns);
  widest_ = std::max(widest_, slots);
  for (ScanTable& table : tables_) {
    table.detections.reserve(densest_);
    table.bearing_from_axis.reserve(densest_);
    table.range.reserve(widest_);
    table.base.reserve(widest_);
    table.lost.reserve(widest_);
    table.group.reserve(widest_);
    table.echo_offset.reserve(widest_);
    table.share.reserve(widest_);
    for (std::vector<float>* of_return : {&table.background, &table.loudness, &table.worth})
      of_return->reserve(std::max(densest_, widest_));
  }
}

const ScanTable& ScanHistory::at_age(int age) const {
  assert(age >= 0 && age < size_);
  return tables_[static_cast<std::size_t>((newest_ - age + capacity()) % capacity())];
}

double ScanHistory::seconds_at_age(int age) const {
  return core::seconds(at_age(age).utime - newest().utime);
}

void ScanHistory::set_figures(const SensorFigures& figures) {
  validate(figures);
  if (size_ == 0) given_ = figures;
  figures_[sensor_] = figures;
  for (int age = 0; age < size_; ++age)
    if (at_age(age).sensor == static_cast<int>(sensor_)) rewrite(table_at(age));
}

void ScanHistory::rewrite(ScanTable& table) const {
  csht::set_figures(figures_[static_cast<std::size_t>(table.sensor)], model_, table);
}

ScanTable& ScanHistory::table_at(int age) {
  assert(age >= 0 && age < size_);
  return tables_[static_cast<std::size_t>((newest_ - age + capacity()) % capacity())];
}

void ScanHistory::group(int age, const SpillModel& spill, std::span<const float> background) {
  spill.group(background, table_at(age));
}

void ScanHistory::set_background(int age, std::span<const float> background) {
  ScanTable& table = table_at(age);
  assert(background.size() == table.background.size());
  std::copy(background.begin(), background.end(), table.background.begin());
  rewrite(table);
}

void ScanHistory::set_loudness(int age, std::span<const float> loudness) {
  ScanTable& table = table_at(age);
  assert(loudness.size() == table.loudness.size());
  std::copy(loudness.begin(), loudness.end(), table.loudness.begin());
  rewrite(table);
}

void ScanHistory::set_heading_error(int age, const HeadingError& error) {
  ScanTable& table = table_at(age);
  csht::set_heading_error(error, figures_[static_cast<std::size_t>(table.sensor)], table);
}

}  // namespace lookout::csht
