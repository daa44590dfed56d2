#pragma once

#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/parameters.hpp"

namespace aisle {

/// What `--print-params` prints: the fields with their current values as a parameter file, and as figures
/// {"params": {key: {"value": ..., "min": ..., "max": ..., "doc": ...}}}; flags have neither min nor max.
Outcome parameter_listing(const std::string& verb, const FieldList& fields);

}  // namespace aisle
