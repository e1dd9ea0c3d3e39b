#include "lcmtypes/log_writer.hpp"

#include <cstdio>
#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <stdexcept>

#include "core/files/text_file.hpp"
#include "core/input_error.hpp"

namespace lookout::lcmtypes {

struct LogWriter::File {
  explicit File(const std::string& path) : log(path, "w") {}
  lcm::LogFile log;
};

LogWriter::LogWriter(const std::string& path) : path_(path) {
  core::require_plain_target(path);
  file_ = std::make_unique<File>(path + ".part");
  if (!file_->log.good()) throw core::InputError(path + ": cannot be written");
}

LogWriter::~LogWriter() {
  if (!file_) return;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(path_ + ".part", ignored);
}

void LogWriter::add_bytes(const std::string& channel, std::int64_t utime, bool is_encoded) {
  if (!is_encoded) throw std::length_error(channel + ": message not encodable");
  lcm::LogEvent event{};
  event.timestamp = utime;
  event.channel = channel;
  event.datalen = static_cast<std::int32_t>(buffer_.size());
  event.data = buffer_.data();
  if (file_->log.writeEvent(&event) != 0) throw std::runtime_error(path_ + ": could not be written");
}

void LogWriter::close() {
  std::FILE* file = file_->log.getFilePtr();
  const bool is_whole = std::fflush(file) == 0 && std::ferror(file) == 0;
  std::error_code failed;
  if (is_whole) std::filesystem::rename(path_ + ".part", path_, failed);
  if (!is_whole || failed) throw std::runtime_error(path_ + ": could not be written completely");
  file_.reset();
}

}  // namespace lookout::lcmtypes
