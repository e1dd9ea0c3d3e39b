#include "tools/cli/plugin.hpp"

#include <dlfcn.h>

#include <exception>
#include <filesystem>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kEntry = "lookout_register";

[[noreturn]] void refuse(const std::string& file, const std::string& reason) {
  throw core::InputError("--plugin: " + file + ": " + reason);
}

/// What went wrong last; the loader begins its message with the path, which `refuse` names already.
std::string loader_error(const std::string& path) {
  const char* text = dlerror();
  const std::string message = text == nullptr ? "cannot be loaded" : text;
  const std::string prefix = path + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

}  // namespace

void load_plugin(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) refuse(file, "no such file, expected a shared library");
  // Without a slash the loader would look in the system's folders.
  const std::string path = std::filesystem::absolute(file).string();
  // Never closed: what it registers lives as long as the program.
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse(file, loader_error(path));
  const auto enter = reinterpret_cast<void (*)()>(dlsym(library, kEntry));
  if (enter == nullptr) refuse(file, std::string("has no function `extern \"C\" void ") + kEntry + "()`");
  try {
    enter();
  } catch (const std::exception& error) {
    refuse(file, error.what());
  }
}

}  // namespace lookout::tools
