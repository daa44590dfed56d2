// A navigator of one's own, in the simulator: it drives ahead until something is near, then it is done.
// 05_write_a_navigator WORLD.yaml VEHICLE.yaml
#include <aisle/formats/worlds/vehicle_yaml.hpp>
#include <aisle/formats/worlds/world_yaml.hpp>
#include <aisle/guidance/navigator.hpp>
#include <aisle/simulation/vehicle/simulated_vehicle.hpp>
#include <algorithm>
#include <iostream>

/// Its only clock is the observations' stamps, so the same observations give the same decisions.
class StopsBeforeWalls final : public aisle::Navigator {
 public:
  aisle::Decision step(const aisle::Observation& observation) override {
    if (observation.bumper_pressed)
      return {.status = aisle::NavigatorStatus::kFailed, .why = "touched something"};
    if (observation.scan) nearest_m_ = nearest_ahead_m(observation.scan->ranges_m);
    if (nearest_m_ < 1) return {.status = aisle::NavigatorStatus::kDone, .state = "there"};
    return {.command = {.speed_mps = std::min(0.4, nearest_m_ - 0.9)}, .state = "driving"};
  }

 private:
  /// In the middle fifth of the scan. A reading of 0 says nothing.
  static float nearest_ahead_m(const std::vector<float>& ranges_m) {
    float nearest_m = 100;
    for (std::size_t i = ranges_m.size() * 2 / 5; i < ranges_m.size() * 3 / 5; ++i)
      if (ranges_m[i] > 0) nearest_m = std::min(nearest_m, ranges_m[i]);
    return nearest_m;
  }

  float nearest_m_ = 0;  ///< before the first scan it is done at once: better than driving blind
};

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "05_write_a_navigator WORLD.yaml VEHICLE.yaml\n", 2;

  const auto world = aisle::read_world(argv[1]);
  const auto model = aisle::read_vehicle(argv[2]);
  if (!world || !model) return std::cerr << to_string(world ? model.problems() : world.problems()) << '\n', 2;
  const auto T_world_start = aisle::start_pose(*world);
  if (!T_world_start) return std::cerr << argv[1] << ": gives no start\n", 2;
  aisle::SimulatedVehicle vehicle(*world, *model, {},
                                  {.T_world_start = *T_world_start, .takes_images = false});

  StopsBeforeWalls navigator;
  aisle::Decision decision;
  while (const auto observation = vehicle.sense()) {
    decision = navigator.step(*observation);
    if (decision.status != aisle::NavigatorStatus::kGoing) break;
    vehicle.act(decision.command);
  }
  vehicle.act({});
  std::cout << (decision.why.empty() ? decision.state : decision.why) << " after " << vehicle.truth().path_m
            << " m\n";
  return decision.status == aisle::NavigatorStatus::kDone ? 0 : 1;
}
