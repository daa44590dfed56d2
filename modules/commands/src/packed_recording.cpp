#include "aisle/commands/packed_recording.hpp"

namespace aisle {
namespace {

void rename_in(nlohmann::ordered_json& value, const UnpackedArchive& archive) {
  if (value.is_string()) value = archive.renamed(value.get<std::string>());
  if (!value.is_structured()) return;
  for (nlohmann::ordered_json& part : value) rename_in(part, archive);
}

}  // namespace

void name_by_archive(Problems& problems, const UnpackedArchive& archive) {
  for (Problem& problem : problems) {
    problem.where.file = archive.renamed(problem.where.file);
    problem.what = archive.renamed(problem.what);
  }
}

void name_by_archive(Outcome& outcome, const UnpackedArchive& archive) {
  outcome.text = archive.renamed(outcome.text);
  rename_in(outcome.figures, archive);
  if (!outcome.figures.contains("warnings")) return;
  for (auto& warning : warnings_json(archive.warnings())) outcome.figures["warnings"].push_back(warning);
}

}  // namespace aisle
