#include "aisle/formats/mazes/maze_file.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto maze = parse_maze(fuzz_text(bytes, size), "input");
  if (!maze.ok()) {
    require(!maze.problems().empty());
    return 0;
  }
  const GridWorld& world = maze->world;
  require(world.contains(world.start));
  if (world.size() > 10000) return 0;
  const auto again = parse_maze(maze_text(world), "written");
  require(again.ok() && again->world.size() == world.size() && again->world.start == world.start);
  for (std::size_t cell = 0; cell < world.size(); ++cell)
    require(again->world.open(cell) == world.open(cell));
  return 0;
}
