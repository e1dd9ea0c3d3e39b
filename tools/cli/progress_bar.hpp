#pragma once

#include <chrono>
#include <cstddef>

namespace lookout::tools {

/// A line on stderr that fills up, shown only on a terminal and only for work that lasts over two seconds.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t total);
  ~ProgressBar();  ///< Ends the line.
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done);

 private:
  std::size_t total_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace lookout::tools
