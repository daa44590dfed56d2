#include "imports/packed_recording.hpp"

#include "aisle/formats/archive.hpp"

namespace aisle {
namespace {

void rename_in(nlohmann::ordered_json& value, const UnpackedArchive& archive) {
  if (value.is_string()) value = archive.renamed(value.get<std::string>());
  if (!value.is_structured()) return;
  for (nlohmann::ordered_json& part : value) rename_in(part, archive);
}

}  // namespace

Result<Outcome> with_unpacked(const std::filesystem::path& recording, Console& console,
                              const RecordingWork& work) {
  if (!is_archive(recording)) return work(recording, console);
  const auto archive = UnpackedArchive::open(recording, console.progress);
  if (!archive) return archive.problems();
  warn_of(archive->warnings(), console);
  Console renaming{console.progress,
                   [&](const std::string& warning) { console.warn(archive->renamed(warning)); },
                   console.watcher};
  auto outcome = work(archive->root(), renaming);
  if (!outcome) {
    Problems problems = outcome.problems();
    for (Problem& problem : problems) {
      problem.where.file = archive->renamed(problem.where.file);
      problem.what = archive->renamed(problem.what);
    }
    return problems;
  }
  outcome->text = archive->renamed(outcome->text);
  rename_in(outcome->figures, *archive);
  if (outcome->figures.contains("warnings")) {
    for (auto& warning : warnings_json(archive->warnings())) outcome->figures["warnings"].push_back(warning);
  }
  return outcome;
}

}  // namespace aisle
