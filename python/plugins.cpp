#include <dlfcn.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "core/input_error.hpp"
#include "python/bindings.hpp"
#include "tools/cli/plugin.hpp"

namespace lookout::python {
namespace {

constexpr const char* kLoadPlugin =
    R"(Loads estimators, trackers and initiators of one's own: what `--plugin FILE.so` is on the command line.

path: a shared library built against lookout::plugin (docs/howto.md, journey 7). Its names go from then on, in
tracker_names(), estimator_names(), track, Tracker, Estimator, Chain and configurations, for the rest of the process.
It must come from the release of this package. ValueError on a file that is no plug-in, and on a name that exists.)";

/// A plug-in takes the library's names from who loads it. Python keeps those of a module to the module: shows
/// them.
void show_names() {
  Dl_info here;
  if (dladdr(reinterpret_cast<void*>(&show_names), &here) == 0 ||
      dlopen(here.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL) == nullptr)
    throw core::InputError("--plugin: the names of the package cannot be shown to it");
}

void load_plugin(const std::filesystem::path& path) {
  show_names();
  tools::load_plugin(path.string());
}

}  // namespace

void bind_plugins(pybind11::module_& module) {
  module.def("load_plugin", &load_plugin, pybind11::arg("path"), kLoadPlugin);
}

}  // namespace lookout::python
