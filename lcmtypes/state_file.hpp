#pragma once

#include <optional>
#include <string>

#include "core/tracking_memory.hpp"

/// A tracker's memory on disk, so that it may go on after a restart. The file is a line that names format and
/// version, size and checksum, then the messages that the memory is made of, as they travel: what a changed
/// type or a damaged file makes of them is refused by the checks of the wire.
namespace lookout::lcmtypes {

/// A memory, or why there is none.
struct LoadedState {
  std::optional<core::TrackingMemory> memory;  ///< Nothing where the file is not there or not good.
  std::string refusal;                         ///< Why a file is not used; empty where there is none.
};

/// Writes the file; under its name stands the old one or all of the new one, whenever the process ends.
/// @throws core::InputError, std::runtime_error as core::write_text_file.
void save_state(const std::string& path, const core::TrackingMemory& memory);

/// Reads it back. Never throws for what the file holds.
LoadedState load_state(const std::string& path);

/// The file's content, and back.
std::string state_text(const core::TrackingMemory& memory);
/// The memory in a file's content, or why there is none.
LoadedState read_state(const std::string& text);

}  // namespace lookout::lcmtypes
