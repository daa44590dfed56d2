#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct LearnOptions {
  std::vector<std::filesystem::path> sessions;  ///< at least one; several only with the method sections
  std::string method = "landmarks";
  std::filesystem::path out;  ///< output directory; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

}  // namespace aisle
