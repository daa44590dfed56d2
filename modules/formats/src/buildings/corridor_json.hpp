#pragma once
/// The parts "corridors" and "places" of a building.

#include <string>
#include <vector>

#include "aisle/maps/building.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string corridors_json(const CorridorGraph& graph);

/// Corridors that do not begin and end at their nodes, or are not as long as they say, are problems.
CorridorGraph read_corridors(const JsonValue& value);

std::string places_json(const std::vector<MapPlace>& places);

/// Names that are empty or stand there twice are problems.
std::vector<MapPlace> read_places(const JsonValue& value);

}  // namespace aisle
