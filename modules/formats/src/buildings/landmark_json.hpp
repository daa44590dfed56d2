#pragma once
/// The part "landmarks" of a building, and which side of a vertical line is the brighter one.

#include <string>

#include "aisle/maps/landmark_map.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

const char* brighter_text(bool is_right);

void read_brighter(const JsonValue& value, bool& is_right);

std::string landmarks_json(const LandmarkMap& map);

LandmarkMap read_landmarks(const JsonValue& value);

}  // namespace aisle
