// An unknown building explored in the simulator: 06_explore_a_building WORLD.yaml VEHICLE.yaml PICTURE.png
#include <aisle/formats/whole_file.hpp>
#include <aisle/formats/worlds/vehicle_yaml.hpp>
#include <aisle/formats/worlds/world_yaml.hpp>
#include <aisle/guidance/exploration/explorer_navigator.hpp>
#include <aisle/report/building_picture.hpp>
#include <aisle/simulation/vehicle/simulated_vehicle.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 4) return std::cerr << "06_explore_a_building WORLD.yaml VEHICLE.yaml PICTURE.png\n", 2;

  const auto world = aisle::read_world(argv[1]);
  const auto model = aisle::read_vehicle(argv[2]);
  if (!world || !model) return std::cerr << to_string(world ? model.problems() : world.problems()) << '\n', 2;
  const auto T_world_start = aisle::start_pose(*world);
  if (!T_world_start) return std::cerr << argv[1] << ": gives no start\n", 2;
  aisle::SimulatedVehicle vehicle(*world, *model, {},
                                  {.T_world_start = *T_world_start, .takes_images = false});

  aisle::ExplorerNavigator explorer({}, model->description, aisle::ExploringOrder::kRecommended,
                                    aisle::scanner_scans(model->description));
  aisle::Decision decision;
  while (decision.status == aisle::NavigatorStatus::kGoing) {
    decision = explorer.step(*vehicle.sense());
    vehicle.act(decision.command);
  }

  aisle::Building building{.name = world->name};
  building.floor = explorer.learner().floor().grid();
  building.places.push_back({aisle::kHomePlace, explorer.learner().T_map_home()});
  std::cout << explorer.record().ended_because << ": " << building.floor->free_m2() << " m2 of floor on "
            << vehicle.truth().path_m << " m, " << vehicle.truth().collisions << " collisions, "
            << (explorer.record().came_home ? "home again\n" : "not home\n");
  const auto problems = aisle::write_whole_file(
      argv[3], png(aisle::BuildingPicture{.building = building, .title = building.name}));
  return problems.empty() && explorer.record().came_home ? 0 : 1;
}
