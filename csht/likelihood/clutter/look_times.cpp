#include "csht/likelihood/clutter/look_times.hpp"

#include <cstdlib>

namespace lookout::csht {

void LookTimes::mark(const LookMemory& memory, std::int64_t utime) {
  times_.clear();
  counted_ = far_ = others_ = 0.0;
  first_ = memory.looks().empty() ? 0 : memory.looks().front().number;
  for (const Look& look : memory.looks()) {
    const std::int64_t lag = std::abs(look.utime - utime);
    const auto number = [](bool it_is) { return it_is ? 1.0F : 0.0F; };
    times_.push_back(
        {number(lag != 0), number(lag > leave_out_us_), number(lag > far_us_), look.utime < utime ? 1U : 0U});
    others_ += lag != 0 ? 1.0 : 0.0;
    counted_ += lag > leave_out_us_ ? 1.0 : 0.0;
    far_ += lag > far_us_ ? 1.0 : 0.0;
  }
}

}  // namespace lookout::csht
