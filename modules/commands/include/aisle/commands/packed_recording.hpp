#pragma once

#include <filesystem>

#include "aisle/commands/outcome.hpp"
#include "aisle/formats/archive.hpp"

namespace aisle {

/// Names files by their place in the archive.
void name_by_archive(Problems& problems, const UnpackedArchive& archive);

/// The same in a verb's result, with the archive's own warnings.
void name_by_archive(Outcome& outcome, const UnpackedArchive& archive);

/// The same in any result that has warnings.
template <class Value>
void name_by_archive(Value& value, const UnpackedArchive& archive) {
  name_by_archive(value.warnings, archive);
  value.warnings.insert(value.warnings.end(), archive.warnings().begin(), archive.warnings().end());
}

/// Works on a recording. One in an archive is unpacked for it, and its files are named by their place in the
/// archive.
/// @param work  Result<Value>(const std::filesystem::path&, Console&)
template <class Work>
auto with_unpacked(const std::filesystem::path& recording, Console& console, const Work& work)
    -> decltype(work(recording, console)) {
  if (!is_archive(recording)) return work(recording, console);
  const auto archive = UnpackedArchive::open(recording, console.progress);
  if (!archive) return archive.problems();
  warn_of(archive->warnings(), console);
  Console renaming{console.progress,
                   [&](const std::string& warning) { console.warn(archive->renamed(warning)); },
                   console.watcher};
  auto result = work(archive->root(), renaming);
  if (result) {
    name_by_archive(*result, *archive);
    return result;
  }
  Problems problems = result.problems();
  name_by_archive(problems, *archive);
  return problems;
}

/// The same for a verb: `work` gets its options with the recording that is there then.
/// @param recording  which of the options it is
template <class Value, class Options, class Path>
Result<Value> with_unpacked(const Options& options, Path Options::*recording, Console& console,
                            Result<Value> (*work)(const Options&, Console&)) {
  return with_unpacked(options.*recording, console,
                       [&](const std::filesystem::path& unpacked, Console& renaming) {
                         Options of_unpacked = options;
                         of_unpacked.*recording = unpacked.string();
                         return work(of_unpacked, renaming);
                       });
}

}  // namespace aisle
