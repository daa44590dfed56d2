#pragma once

#include <string>
#include <string_view>

#include "aisle/formats/mazes/maze_file.hpp"

namespace aisle {

Result<MazeFile> parse_maze_binary(std::string_view bytes, const std::string& name);

}  // namespace aisle
