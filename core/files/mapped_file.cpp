#include "core/files/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>

#include "core/input_error.hpp"

namespace lookout::core {
namespace {

std::span<const std::uint8_t> map_file(const std::string& path, std::string_view expected) {
  const std::string wanted = "expected " + std::string(expected);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path + ": is not a file; " + wanted);
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(path, error));
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (error || descriptor < 0) throw InputError(path + ": cannot be read; " + wanted);
  void* memory = size == 0 ? nullptr : mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  close(descriptor);
  if (memory == MAP_FAILED) throw InputError(path + ": cannot be read; " + wanted);
  return {static_cast<const std::uint8_t*>(memory), size};
}

}  // namespace

MappedFile::MappedFile(const std::string& path, std::string_view expected)
    : bytes_(map_file(path, expected)) {}

MappedFile::~MappedFile() {
  // The mapping was made for reading alone, which the signature of munmap does not know.
  if (!bytes_.empty()) munmap(const_cast<std::uint8_t*>(bytes_.data()), bytes_.size());
}

}  // namespace lookout::core
