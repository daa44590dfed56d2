#pragma once

#include <filesystem>
#include <functional>

#include "aisle/commands/outcome.hpp"

namespace aisle {

using RecordingWork = std::function<Result<Outcome>(const std::filesystem::path&, Console&)>;

/// Works on a recording. One in an archive is unpacked for it, and its files are named by their place in the
/// archive.
Result<Outcome> with_unpacked(const std::filesystem::path& recording, Console& console,
                              const RecordingWork& work);

}  // namespace aisle
