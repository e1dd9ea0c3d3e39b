#pragma once

#include <stdexcept>

namespace lookout::core {

/// Bad input from a user: a file, a line, a field or a flag. The text is one line that says where, what is
/// wrong and what is accepted; the command line prints it and exits with status 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lookout::core
