// The compiled part of the Python package: what python/lookout/__init__.py gives to its user.
#include "core/input_error.hpp"
#include "python/bindings.hpp"
#include "python/rows.hpp"
#include "tools/cli/version.hpp"

namespace lookout::python {
namespace {

/// An InputError of the library is Python's ValueError; std::invalid_argument and std::length_error are one
/// already.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const core::InputError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

}  // namespace
}  // namespace lookout::python

PYBIND11_MODULE(_lookout, module) {
  using namespace lookout;
  pybind11::register_exception_translator(&python::translate);
  python::bind_rows(module);
  python::bind_scans(module);
  python::bind_files(module);
  python::bind_simulation(module);
  python::bind_tracking(module);
  python::bind_plugins(module);
  python::bind_metrics(module);
  module.attr("__version__") = tools::release();
}
