#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct ReproduceOptions {
  std::string experiment;  ///< "c98", "c99" or "l03"
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< output directory; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

}  // namespace aisle
