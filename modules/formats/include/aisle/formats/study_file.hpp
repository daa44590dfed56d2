#pragma once
/// Study files: one trial in several variants; see docs/formats/study.md.

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

struct StudyVariant {
  std::string name;   ///< unique in the study, whatever its case and signs
  std::string words;  ///< of a command line: what this variant's trial has beyond the others
};

struct Study {
  std::string trial;                   ///< a command line behind `aisle trial`, without seeds
  std::string seeds;                   ///< "A..B" or "A"
  std::vector<std::string> figures;    ///< of the missions, compared beside whether they went well
  std::vector<StudyVariant> variants;  ///< at least two; the others are compared with the first
};

/// Reads a study file; all problems are reported together, each with its line and key.
Result<Study> read_study(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<Study> parse_study(const std::string& text, const std::string& name);

/// A variant's name as a part of a path: letters, digits and = . _ -, in lower case.
std::string directory_of(const StudyVariant& variant);

}  // namespace aisle
