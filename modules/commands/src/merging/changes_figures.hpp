#pragma once
/// What has changed between two maps, as verbs report it.

#include <nlohmann/json.hpp>
#include <string>

#include "aisle/merging/building_changes.hpp"

namespace aisle {

/// {"walls_m": {...}, "floor_m2": {...}, "doors": [...], "changed_walls": [...]}; each wall once, what has
/// moved as the new map shows it.
nlohmann::ordered_json changes_json(const BuildingChanges& changes);

/// The same for people, a line for each change. @param figures  has what `changes_json` gives
std::string changes_text(const nlohmann::ordered_json& figures);

/// The same in one line, below a picture.
std::string changes_caption(const nlohmann::ordered_json& figures);

}  // namespace aisle
