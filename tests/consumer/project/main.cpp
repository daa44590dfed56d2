#include <aisle/formats/logs/read_laser_recording.hpp>
#include <aisle/learning/walls/map_building.hpp>
#include <iostream>

int main(int, char** argv) {
  const auto recording = aisle::read_laser_recording(argv[1]);
  if (!recording) return 2;
  aisle::SilentProgress progress;
  const auto map = aisle::build_map(recording->log, {}, {}, false, progress);
  std::cout << map.walls.walls.size() << " walls\n";
}
