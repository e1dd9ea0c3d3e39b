#include "core/files/stamp_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/files/time_text.hpp"
#include "core/frames.hpp"

namespace lookout::core {
namespace {

/// Times that a 32-bit float holds only to this or worse [s] are those of a clock since 1970.
constexpr float kCoarseFloat = 16.0F;
/// A stamp stated to no better than this [s], with an exponent, has lost its digits.
constexpr double kCoarseDigits = 1.0;
/// Where all times are whole multiples of so many periods, stamps were cut, or the period is another.
constexpr double kPeriodsPerStamp = 1.1;
constexpr std::size_t kFewestScans = 3;
constexpr std::size_t kTellingReturns = 50;  // Fewer may lie ahead by chance.
/// Stamps that were cut are whole multiples of this at least [us]; a driver's own clock is finer.
constexpr std::int64_t kCoarseUnit = 500;
constexpr double kSameBearing = 1e-9;  // [rad]

constexpr const char* kCure = "were the times cut short? Export them in full, with six decimals";

bool is_float_time(std::int64_t utime) {
  const double time = seconds(utime);
  const auto rounded = static_cast<float>(time);
  const float next = std::nextafter(rounded, std::numeric_limits<float>::infinity());
  return next - rounded >= kCoarseFloat && static_cast<double>(rounded) == time;
}

/// What all times are whole multiples of, from the first on [us].
std::int64_t unit_of(const std::vector<SonarScan>& scans) {
  std::int64_t unit = 0;
  for (std::size_t i = 1; i < scans.size(); ++i) unit = std::gcd(unit, scans[i].utime - scans[i - 1].utime);
  return unit;
}

bool in_order_of_bearing(const SonarScan& scan) {
  const auto before = [](const SonarReturn& a, const SonarReturn& b) {
    return a.bearing < b.bearing || (a.bearing == b.bearing && a.range < b.range);
  };
  return std::is_sorted(scan.returns.begin(), scan.returns.end(), before) ||
         std::is_sorted(scan.returns.rbegin(), scan.returns.rend(), before);
}

bool holds_a_beam_twice(const SonarScan& scan, bool knows_beams) {
  std::vector<double> beams;
  for (const SonarReturn& one : scan.returns)
    beams.push_back(knows_beams ? std::round((one.bearing - scan.first_bearing) / scan.bearing_step)
                                : one.bearing);
  std::sort(beams.begin(), beams.end());
  return std::adjacent_find(beams.begin(), beams.end(),
                            [](double a, double b) { return b - a <= kSameBearing; }) != beams.end();
}

bool lost_digits(const std::string& text) {
  return text.find_first_of("eE") != std::string::npos && stated_resolution(text) >= kCoarseDigits;
}

}  // namespace

void ScanStamps::add(std::size_t row, std::int64_t utime, bool blank, bool new_scan) {
  if (new_scan) {
    times_.push_back(utime);
    first_row_.push_back(row);
    rows_in_scan_ = 0;
    scan_is_blank_ = blank;
  } else if (blank || scan_is_blank_) {
    table_.fail(row, "time_s", "a scan without returns has the time of another row; " + std::string(kCure));
  }
  if (++rows_in_scan_ > kMostReturns)
    table_.fail(row, "time_s",
                "more than " + std::to_string(kMostReturns) + " returns at one time; " + kCure);
}

bool ScanStamps::only_floats() const {
  return times_.size() > 1 && std::all_of(times_.begin(), times_.end(), is_float_time);
}

void ScanStamps::finish(std::vector<std::string>& notes) const {
  if (only_floats())
    table_.fail(first_row_[1], "time_s", "every time is one of a 32-bit float; " + std::string(kCure));
  if (table_.num_rows() < 2) return;
  bool all_lost = true;
  for (std::size_t row = 0; row < table_.num_rows(); ++row)
    all_lost &= lost_digits(table_.text(row, "time_s"));
  if (all_lost)
    table_.fail(1, "time_s",
                "got `" + table_.text(1, "time_s") + "`, and no time in the file says more; " + kCure);
  if (times_.size() == 1)
    notes.push_back(table_.path() + ":" + std::to_string(table_.line(1)) + ": all " +
                    std::to_string(table_.num_rows()) + " rows share one time; if they are several scans, " +
                    kCure);
}

bool ReturnChecks::is_return(std::size_t row, const SonarReturn& one) {
  if (std::isnan(one.bearing) || std::isnan(one.range)) return silences_.add(row), false;
  ++returns_;
  widest_ = std::max(widest_, std::abs(one.bearing));
  if (std::abs(one.bearing) > 2.0 * std::numbers::pi) beyond_a_turn_.add(row);
  return true;
}

void ReturnChecks::note(std::vector<std::string>& notes, const Count& count, const std::string& what) const {
  if (count.number == 0) return;
  notes.push_back(table_.path() + ":" + std::to_string(table_.line(count.first_row)) + ": " +
                  std::to_string(count.number) + " of " + std::to_string(table_.num_rows()) + " rows " +
                  what + " (this is the first)");
}

void ReturnChecks::finish(std::vector<std::string>& notes) const {
  note(notes, silences_, "have no finite bearing or range: taken as silences");
  note(notes, beyond_a_turn_,
       "have a " + bearing_column_ + " beyond a full turn" +
           (bearing_column_ == "bearing_rad" ? ": if they are degrees, name the column bearing_deg" : ""));
  // Half a turn in radians; hardly a sonar has so narrow a fan in degrees.
  if (bearing_column_ == "bearing_deg" && returns_ >= kTellingReturns && degrees(widest_) <= std::numbers::pi)
    notes.push_back(table_.path() + ": all " + std::to_string(returns_) +
                    " returns have a bearing_deg within " +
                    shortest(std::ceil(100.0 * degrees(widest_)) / 100.0) +
                    " of ahead: if they are radians, name the column bearing_rad");
}

std::optional<std::string> coarse_stamps(const std::vector<SonarScan>& scans,
                                         std::optional<double> stated_period) {
  if (!stated_period || scans.size() < kFewestScans) return std::nullopt;
  const std::int64_t unit = unit_of(scans);
  if (seconds(unit) < kPeriodsPerStamp * *stated_period) return std::nullopt;
  return "times are whole multiples of " + time_text(unit) + " s, but sonar.yaml states scan_period " +
         shortest(*stated_period) + " s; if one time holds several scans, " + kCure;
}

std::optional<MergedScans> merged_scans(const std::vector<SonarScan>& scans, bool knows_beams) {
  if (scans.size() < kFewestScans || unit_of(scans) < kCoarseUnit) return std::nullopt;
  std::size_t several = 0, twice = 0, first = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    several += scans[i].returns.size() > 1 ? 1 : 0;
    if (in_order_of_bearing(scans[i]) || !holds_a_beam_twice(scans[i], knows_beams)) continue;
    if (twice++ == 0) first = i;
  }
  if (twice < kFewestScans || 2 * twice < several) return std::nullopt;
  return MergedScans{
      first, std::to_string(twice) + " of " + std::to_string(scans.size()) +
                 " times hold two returns of one beam, not in order: if they are several scans, " + kCure};
}

}  // namespace lookout::core
