#pragma once
/// Decisions and operator input as the JSON of their topics. Numbers have enough digits to read back the same
/// bits.

#include <optional>
#include <string>

#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

std::string decision_text(const Decision& decision);
std::string operator_text(const OperatorInput& input);

/// @return nullopt if the text is not a decision, or not operator input
std::optional<Decision> parse_decision(const std::string& text);
std::optional<OperatorInput> parse_operator(const std::string& text);

}  // namespace aisle
