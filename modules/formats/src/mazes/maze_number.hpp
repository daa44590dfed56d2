#pragma once

#include <string>
#include <string_view>

#include "aisle/formats/mazes/maze_file.hpp"

namespace aisle {

Result<MazeFile> parse_maze_number(std::string_view text, const std::string& name);

}  // namespace aisle
