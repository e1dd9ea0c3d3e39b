#include "tools/cli/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace lookout::tools {
namespace {

constexpr std::chrono::seconds kSilentFor{2};
constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::size_t kWidth = 40;

}  // namespace

ProgressBar::ProgressBar(std::size_t total)
    : total_(std::max<std::size_t>(total, 1)),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputc('\n', stderr);
}

void ProgressBar::show(std::size_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - start_ < kSilentFor || (now - last_ < kRedraw && done < total_)) return;
  const std::size_t filled = kWidth * done / total_;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left =
      done > 0 ? elapsed * static_cast<double>(total_ - done) / static_cast<double>(done) : 0.0;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %zu/%zu, %.0f s left ", bar.c_str(), done, total_, left);
  last_ = now;
  shown_ = true;
}

}  // namespace lookout::tools
