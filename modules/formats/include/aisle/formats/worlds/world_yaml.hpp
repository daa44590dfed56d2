#pragma once
/// World files of the simulator; docs/formats/world.md specifies both formats.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

inline constexpr std::size_t kWorldWallsMax = 200'000;  ///< of a world that is read or made

/// Reads a world file; all problems are reported together, each with its line and key.
Result<World> read_world(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<World> parse_world(const std::string& text, const std::string& name);

/// The world as the text of a world file. Consecutive walls that join become polylines; coordinates are
/// rounded to millimetres.
std::string world_yaml(const World& world);

/// Reads a floor given as wall segments, one "x1 y1 x2 y2 kind" per line. The world is named after the file
/// and has no tour.
Result<World> read_wall_segments(const std::filesystem::path& path);

/// The same from memory.
Result<World> parse_wall_segments(std::string_view text, const std::string& name);

}  // namespace aisle
