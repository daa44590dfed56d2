#pragma once

#include <string>

#include "aisle/commands/outcome.hpp"

namespace aisle {

/// `aisle list [worlds|vehicles|scenarios]`: the files that come with the program and can be given by name.
/// @param kind  empty: all kinds
Result<Outcome> run_list_shipped(const std::string& kind);

}  // namespace aisle
