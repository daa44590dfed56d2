// What a building file holds, and a picture of it: 02_look_into_a_building BUILDING.json PICTURE.png
#include <aisle/formats/buildings/building_json.hpp>
#include <aisle/formats/whole_file.hpp>
#include <aisle/report/building_picture.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "02_look_into_a_building BUILDING.json PICTURE.png\n", 2;

  const auto building = aisle::read_building(argv[1]);
  if (!building) return std::cerr << to_string(building.problems()) << '\n', 2;

  std::cout << building->walls.walls.size() << " walls, " << building->walls.length_m()
            << " m long together\n";
  for (const aisle::MapPlace& place : building->places)
    std::cout << "place '" << place.name << "' at " << place.T_map_place.x << ", " << place.T_map_place.y
              << '\n';
  if (building->floor) std::cout << building->floor->free_m2() << " m2 of free floor\n";

  const std::string picture = png(aisle::BuildingPicture{.building = *building, .title = building->name});
  const aisle::Problems problems = aisle::write_whole_file(argv[2], picture);
  return problems.empty() ? 0 : (std::cerr << to_string(problems) << '\n', 2);
}
