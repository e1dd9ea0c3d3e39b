#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tracking {

/// When a time is believed.
struct ClockGuardParams {
  /// Farthest step ahead that is still the same clock [us], > 0. Longer than any tracker remembers, so that a
  /// reset after a pause forgets nothing that is worth keeping.
  std::int64_t max_step = 60'000'000;
  int new_clock_after = 5;  ///< Consistent times on another clock after which that one is believed, >= 1.
  std::int64_t max_late =
      1'000'000;  ///< Farthest step back that is a late message of the same clock [us], >= 0.
  /// Farthest step ahead that is believed at once [us], > 0, or three times the step before where that is
  /// longer: a longer one is a pause if the next time agrees, else one bad stamp.
  std::int64_t max_leap = 1'000'000;
};

/// Judges the times of one stream, in the order of their arrival. A time that goes back or leaps ahead is
/// suspect; when enough suspects in a row follow one another, the stream has made a pause or is on a new
/// clock. Two leaps in a row that are alike, each above a third of `max_step`, are a slow stream's pace.
class ClockGuard {
 public:
  /// What a time is to those before it.
  enum class Verdict {
    in_order,  ///< Later than all before.
    late,      ///< A little earlier than the newest, or equal to it.
    suspect,   ///< To be kept until others agree with it.
    resumed,   ///< Agrees with the suspect before: the same clock, after a pause.
    new_clock  ///< Agrees with the suspects before: another clock.
  };

  /// @throws std::invalid_argument on params out of range.
  explicit ClockGuard(const ClockGuardParams& params = {});

  /// Takes the next time in the order of arrival [us].
  Verdict judge(std::int64_t utime);

  std::optional<std::int64_t> last() const { return last_; }  ///< Newest time on the believed clock [us].
  int suspects() const { return num_suspects_; }              ///< In a row, the newest among them.

  /// Believes the suspects' clock at once if its newest time is near `utime`. Returns whether it does.
  bool adopt_suspects_near(std::int64_t utime);

  /// At the end of a stream, where nothing more can agree: believes suspects that lie ahead on the same
  /// clock. Returns whether there are such.
  bool adopt_suspects_ahead();

  /// The next time may lie ahead by up to `max_step` and is believed at once: nobody listened meanwhile.
  void expect_pause() { expects_pause_ = true; }

  void forget() { *this = ClockGuard(params_); }  ///< The next time is the first.

 private:
  bool follows(std::int64_t before, std::int64_t utime) const;
  std::int64_t max_step() const { return params_.max_step > slow_ ? params_.max_step : slow_; }
  void watch_slow_pace(std::int64_t utime);
  Verdict suspect(std::int64_t utime);
  void believe(std::int64_t utime);

  ClockGuardParams params_;
  std::optional<std::int64_t> last_;
  std::int64_t step_ = 0;  ///< Between the newest two believed times [us].
  std::int64_t newest_suspect_ = 0;
  int num_suspects_ = 0;
  bool expects_pause_ = false;
  std::int64_t leap_ = 0;  ///< Of the newest suspect from the time before it [us].
  std::int64_t slow_ = 0;  ///< Farthest step of a stream that proves to be slower than `max_step` [us].
};

}  // namespace lookout::tracking
