#include <aisle/formats/logs/carmen_log.hpp>
#include <aisle/learning/walls/map_building.hpp>
#include <iostream>

int main(int, char** argv) {
  const auto carmen = aisle::read_carmen_log(argv[1]);
  if (!carmen) return 2;
  aisle::SilentProgress progress;
  const auto map = aisle::build_map(carmen->log, {}, {}, false, progress);
  std::cout << map.walls.walls.size() << " walls\n";
}
