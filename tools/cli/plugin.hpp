#pragma once

#include <string>

namespace lookout::tools {

/// Loads a plug-in, a shared library that adds methods from outside, for the rest of the program's life, and
/// calls its `extern "C" void lookout_register()`, which calls csht::register_estimator,
/// tracking::register_tracker and tracking::register_initiator. Build one against the target lookout::plugin
/// of the installed package.
/// @param file its path, absolute or from the working directory.
/// @throws core::InputError where it is missing, is no shared library, needs what this program has not, has
/// no `lookout_register`, or what that throws.
void load_plugin(const std::string& file);

}  // namespace lookout::tools
