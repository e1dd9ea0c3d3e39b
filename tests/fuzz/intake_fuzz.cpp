// Vehicle states and scans, a few bytes each, into an intake: times that leap and go back, numbers of several
// senders, returns of every kind. What leaves is in order and finite, and every scan is accounted for.
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <span>

#include "tests/fuzz/fuzz_support.hpp"
#include "tracking/intake/scan_intake.hpp"

namespace lookout::tests {
namespace {

constexpr std::int64_t kTenth = 100'000, kSecond = 1'000'000;  // [us]
constexpr std::array kLeaps{std::int64_t{0}, 30 * kSecond, -3 * kSecond, 36'000 * kSecond};
constexpr std::array kAngles{0.0, 0.3, -0.3, 40.0};

/// Bytes taken from the front; 0 where there are no more.
class Source {
 public:
  explicit Source(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  std::int64_t small() { return static_cast<std::int8_t>(byte()); }
  /// Any double that there is, or an ordinary one.
  double number() {
    if (const std::uint8_t plain = byte(); plain != 0) return plain;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof bits; ++i) bits = bits << 8U | byte();
    return std::bit_cast<double>(bits);
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// An intake that is fed and watched.
class WatchedIntake {
 public:
  explicit WatchedIntake(Source source) : source_(source) {}

  void run() {
    while (!source_.empty()) step(source_.byte());
    intake_.finish();
    const tracking::IntakeCounts& counts = intake_.counts();
    require(counts.received == counts.accepted + counts.rejected() + counts.shed);
    require(counts.states == counts.accepted_states + counts.bad_states);
    require(counts.accepted == accepted_ && counts.resets == resets_ && counts.lost >= 0);
  }

 private:
  void step(std::uint8_t kind) {
    now_ += source_.small() * kTenth + kLeaps[kind >> 2U & 3U] * (kind >> 4U & 1U);
    if ((kind & 1U) == 0) return intake_.add(state(kind));
    core::SonarScan ping = scan(kind);
    if ((kind >> 1U & 1U) != 0 && kind > 0xE0) return intake_.shed(ping);
    intake_.add(std::move(ping));
  }
  core::VehicleState state(std::uint8_t kind) {
    const double heading = kAngles[kind >> 5U & 3U];
    return {now_, {(kind & 2U) != 0 ? source_.number() : core::seconds(now_), 0.0, heading}, {1.0, 0.0}};
  }
  core::SonarScan scan(std::uint8_t kind) {
    core::SonarScan scan;
    scan.utime = now_;
    scan.sequence = sequence_ += source_.small();
    scan.sensor_id = kind >> 5U;
    scan.first_bearing = core::SonarParams().first_bearing;
    scan.bearing_step = core::SonarParams().bearing_step;
    scan.max_range = (kind & 2U) != 0 ? source_.number() : core::SonarParams().max_range;
    scan.num_beams = core::SonarParams().num_beams;
    for (int i = source_.byte() % 8; i > 0; --i)
      scan.returns.push_back({kAngles[source_.byte() % kAngles.size()], source_.number(), 1.0});
    return scan;
  }
  void accept(const core::PosedScan& posed) {
    ++accepted_;
    const auto before = last_.find(posed.scan.sensor_id);
    require(before == last_.end() || posed.scan.utime > before->second);
    require(posed.scan.utime >= newest_);
    newest_ = last_[posed.scan.sensor_id] = posed.scan.utime;
    require(std::isfinite(posed.T_earth_sonar.north) && std::isfinite(posed.T_earth_sonar.heading));
    for (const auto& one : posed.scan.returns) require(one.range > 0.0 && one.range <= posed.scan.max_range);
  }
  void reset() {
    ++resets_;
    last_.clear();
    newest_ = -core::kMaxUtime;
  }

  Source source_;
  std::int64_t now_ = 0, sequence_ = 0, accepted_ = 0, resets_ = 0, newest_ = -core::kMaxUtime;
  std::map<std::int32_t, std::int64_t> last_;
  tracking::ScanIntake intake_{core::SonarParams(),
                               {[this](const core::PosedScan& posed) { accept(posed); }, [this] { reset(); },
                                [](const std::string&) {}}};
};

}  // namespace
}  // namespace lookout::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lookout::tests;
  WatchedIntake(Source({data, size})).run();
  return 0;
}
