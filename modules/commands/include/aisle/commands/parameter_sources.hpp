#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/parameters.hpp"

namespace aisle {

/// Where a verb's parameters come from. Later ones override earlier ones: defaults < files < settings.
struct ParameterSources {
  std::vector<std::filesystem::path> files;  ///< --params FILE
  std::vector<std::string> settings;         ///< --set key=value

  /// Assigns all values. @return all problems at once; empty on success
  Problems apply_to(FieldList& fields) const;
};

}  // namespace aisle
