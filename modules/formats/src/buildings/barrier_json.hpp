#pragma once
/// The part "barriers" of a building.

#include <string>
#include <vector>

#include "aisle/maps/barrier.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string barriers_json(const std::vector<Barrier>& barriers);

std::vector<Barrier> read_barriers(const JsonValue& value);

}  // namespace aisle
