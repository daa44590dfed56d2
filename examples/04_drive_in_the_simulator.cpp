// A vehicle in a simulated world, one cycle at a time: 04_drive_in_the_simulator WORLD.yaml VEHICLE.yaml
#include <aisle/formats/worlds/vehicle_yaml.hpp>
#include <aisle/formats/worlds/world_yaml.hpp>
#include <aisle/simulation/vehicle/simulated_vehicle.hpp>
#include <aisle/vehicle/odometry_step.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "04_drive_in_the_simulator WORLD.yaml VEHICLE.yaml\n", 2;

  const auto world = aisle::read_world(argv[1]);
  const auto model = aisle::read_vehicle(argv[2]);
  if (!world || !model) return std::cerr << to_string(world ? model.problems() : world.problems()) << '\n', 2;
  const auto T_world_start = aisle::start_pose(*world);
  if (!T_world_start) return std::cerr << argv[1] << ": gives no start\n", 2;

  aisle::SimulatedVehicle vehicle(*world, *model, {},
                                  {.seed = 1, .T_world_start = *T_world_start, .takes_images = false});
  aisle::Pose2 T_world_odometry = *T_world_start;
  for (int cycle = 0; cycle < 100; ++cycle) {
    const auto observation = vehicle.sense();
    T_world_odometry = T_world_odometry * odometry_step(model->description, observation->odometry);
    vehicle.act({.speed_mps = 0.3});
  }
  const aisle::Truth& truth = vehicle.truth();
  const auto error = between(truth.T_world_vehicle, T_world_odometry);
  std::cout << "drove " << truth.path_m << " m with " << truth.collisions
            << " collisions; the odometry is off by " << error.position().norm() << " m\n";
}
