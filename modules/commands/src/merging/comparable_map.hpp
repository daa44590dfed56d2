#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "aisle/commands/outcome.hpp"
#include "aisle/merging/map_alignment.hpp"

namespace aisle {

/// A building, or a map of map_server, that can be compared with others: it has walls and a floor.
Result<Building> read_comparable_map(const std::filesystem::path& file, Console& console);

/// What keeps a building from being compared with others; empty: nothing.
/// @param file  that it was read from, for messages
Problems not_comparable(const Building& building, const std::filesystem::path& file);

/// {"verdict": ..., "common_m": ..., "rival_share": ..., "x_m": ..., ...}: how a map lies to another, and how
/// sure that is.
nlohmann::ordered_json alignment_json(const MapAlignment& alignment);

nlohmann::ordered_json placement_json(const Pose2& T);

}  // namespace aisle
