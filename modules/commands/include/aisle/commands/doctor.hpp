#pragma once

#include "aisle/commands/outcome.hpp"

namespace aisle {

/// `aisle doctor`: looks at the machine, and changes nothing. Not ok if something is missing that every use
/// needs.
Result<Outcome> run_doctor();

}  // namespace aisle
