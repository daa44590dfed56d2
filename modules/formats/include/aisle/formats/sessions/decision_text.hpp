#pragma once
/// Decisions and operator input as the JSON of their topics. Numbers are written with as many digits as
/// it takes to read the same bits.

#include <optional>
#include <string>

#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

std::string decision_text(const Decision& decision);
std::string operator_text(const OperatorInput& input);

/// @return nullopt if the text is nothing of the kind
std::optional<Decision> parse_decision(const std::string& text);
std::optional<OperatorInput> parse_operator(const std::string& text);

}  // namespace aisle
