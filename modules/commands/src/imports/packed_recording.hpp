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

/// The same for a verb: `work` gets its options with the recording that is there then.
/// @param recording  which of the options it is
template <class Options, class Path>
Result<Outcome> with_unpacked(const Options& options, Path Options::*recording, Console& console,
                              Result<Outcome> (*work)(const Options&, Console&)) {
  return with_unpacked(options.*recording, console,
                       [&](const std::filesystem::path& unpacked, Console& renaming) {
                         Options of_unpacked = options;
                         of_unpacked.*recording = unpacked.string();
                         return work(of_unpacked, renaming);
                       });
}

}  // namespace aisle
