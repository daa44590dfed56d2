#pragma once
/// The parts "corridors" and "places" of a building.

#include <string>
#include <vector>

#include "aisle/maps/building.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string corridors_json(const CorridorGraph& graph);

/// Corridors that do not begin and end at their nodes, or whose length does not match their path, are
/// problems.
CorridorGraph read_corridors(const JsonValue& value);

std::string places_json(const std::vector<MapPlace>& places);

/// Empty and duplicate names are problems.
std::vector<MapPlace> read_places(const JsonValue& value);

}  // namespace aisle
