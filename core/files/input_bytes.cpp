#include "core/files/input_bytes.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/input_error.hpp"

namespace lookout::core {
namespace {

constexpr std::size_t kLargestFile = std::size_t{2} << 30;  // A device without an end is not read for ever.
/// Read at once; what is read so far, within these: a small file does not cost a large buffer.
constexpr std::size_t kFewest = std::size_t{1} << 12, kMost = std::size_t{1} << 20;
constexpr int kForEver = -1;  // Of poll.

/// An open file, and how it is spoken of.
class Source {
 public:
  Source(const std::string& path, std::string_view expected, const PipePatience& patience)
      : path_(path),
        expected_(expected),
        patience_(patience),
        descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Source() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  std::string read_all() {
    require_readable();
    std::string bytes;
    bool has_zero = false;
    while (!has_zero && bytes.size() <= kLargestFile) {
      const std::size_t before = bytes.size();
      if (!read_some(bytes)) return bytes;
      has_zero = bytes.find('\0', before) != std::string::npos;
    }
    if (!has_zero) refuse("is above 2 GB");
    return bytes;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(path_ + ": " + what + "; expected " + expected_);
  }

  void require_readable() const {
    struct stat kind {};
    if (descriptor_ < 0 || fstat(descriptor_, &kind) != 0) refuse("cannot be read");
    if (S_ISDIR(kind.st_mode)) refuse("is a directory");
  }

  /// Appends the next bytes. @return false at the end.
  bool read_some(std::string& bytes) const {
    const std::size_t before = bytes.size(), chunk = std::clamp(before, kFewest, kMost);
    bytes.resize(before + chunk);
    const ssize_t got = read_when_there(bytes.data() + before, chunk, before > 0);
    bytes.resize(before + static_cast<std::size_t>(got));
    return got > 0;
  }

  /// A pipe without a writer reads as ended, also before the first has come: where nothing was read yet, one
  /// is waited for.
  ssize_t read_when_there(char* to, std::size_t size, bool has_begun) const {
    bool may_wait = !has_begun && is_pipe();
    for (;;) {
      const ssize_t got = read(descriptor_, to, size);
      if (got > 0 || (got == 0 && !may_wait)) return got;
      if (got < 0 && errno != EAGAIN && errno != EINTR) refuse("cannot be read");
      const auto patience = got == 0 ? patience_.writer : patience_.silence;
      const int heard = wait(isatty(descriptor_) != 0 ? kForEver : static_cast<int>(patience.count()));
      if (heard == 0) refuse("is a pipe into which nobody writes");
      may_wait = may_wait && got < 0;
    }
  }

  bool is_pipe() const {
    struct stat kind {};
    return fstat(descriptor_, &kind) == 0 && S_ISFIFO(kind.st_mode);
  }

  int wait(int milliseconds) const {
    pollfd there{descriptor_, POLLIN, 0};
    return poll(&there, 1, milliseconds);
  }

  std::string path_, expected_;
  PipePatience patience_;
  int descriptor_;
};

}  // namespace

std::string input_bytes(const std::string& path, std::string_view expected, const PipePatience& patience) {
  return Source(path, expected, patience).read_all();
}

}  // namespace lookout::core
