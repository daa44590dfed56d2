// A wall map from a recorded laser log: 01_map_a_log LOG BUILDING.json
#include <aisle/formats/buildings/building_json.hpp>
#include <aisle/formats/logs/read_laser_recording.hpp>
#include <aisle/formats/whole_file.hpp>
#include <aisle/learning/walls/map_building.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "01_map_a_log LOG BUILDING.json\n", 2;

  const auto recording = aisle::read_laser_recording(argv[1]);
  if (!recording) return std::cerr << to_string(recording.problems()) << '\n', 2;

  aisle::SilentProgress progress;
  const auto map = aisle::build_map(recording->log, {}, {}, false, progress);

  aisle::Building building{.name = argv[1], .has_dominant_direction = map.has_dominant_direction};
  building.walls = map.walls;
  std::cout << map.T_map_vehicle.size() << " scans, " << map.path_m << " m of path, "
            << map.walls.walls.size() << " walls, " << map.loop_closures.size() << " loop closures\n";
  const aisle::Problems problems = aisle::write_whole_file(argv[2], building_json(building));
  return problems.empty() ? 0 : (std::cerr << to_string(problems) << '\n', 2);
}
