// To a point of an explored building, in the simulator: 07_go_to_a_place BUILDING.json WORLD.yaml
// VEHICLE.yaml X Y
#include <aisle/formats/buildings/building_json.hpp>
#include <aisle/formats/worlds/vehicle_yaml.hpp>
#include <aisle/formats/worlds/world_yaml.hpp>
#include <aisle/guidance/exploration/guide_navigator.hpp>
#include <aisle/simulation/vehicle/simulated_vehicle.hpp>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 6) return std::cerr << "07_go_to_a_place BUILDING.json WORLD.yaml VEHICLE.yaml X Y\n", 2;

  const auto building = aisle::read_building(argv[1]);
  if (!building) return std::cerr << to_string(building.problems()) << '\n', 2;
  if (!building->floor || building->places.empty()) return std::cerr << argv[1] << ": was not explored\n", 2;
  const auto world = aisle::read_world(argv[2]);
  const auto model = aisle::read_vehicle(argv[3]);
  if (!world || !model) return std::cerr << to_string(world ? model.problems() : world.problems()) << '\n', 2;
  const auto T_world_start = aisle::start_pose(*world);
  if (!T_world_start) return std::cerr << argv[2] << ": gives no start\n", 2;
  aisle::SimulatedVehicle vehicle(*world, *model, {},
                                  {.T_world_start = *T_world_start, .takes_images = false});

  // The world's start is where the exploration began, so it is home; in `map` home has its own pose.
  const aisle::GoalPlace goal{.p_map = {std::atof(argv[4]), std::atof(argv[5])}};
  aisle::GuideNavigator guide({}, model->description, *building, building->places.front().T_map_place, {goal},
                              aisle::scanner_scans(model->description));
  aisle::Decision decision;
  while (decision.status == aisle::NavigatorStatus::kGoing) {
    decision = guide.step(*vehicle.sense());
    vehicle.act(decision.command);
  }
  std::cout << decision.state << ' ' << decision.why << " after " << vehicle.truth().path_m << " m, at "
            << guide.T_map_vehicle().x << ", " << guide.T_map_vehicle().y << '\n';
  return decision.status == aisle::NavigatorStatus::kDone ? 0 : 1;
}
