#include "rooms/taught_rooms.hpp"

#include <utility>
#include <vector>

#include "aisle/guidance/hand_driver.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/simulation/operators/route_guide.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// Records a drive with the true poses.
class RoomRunRecord final : public MissionRecord {
 public:
  RoomRunRecord(const RoomLearnerParams& params, const VehicleDescription& vehicle, const TruthSource& truth)
      : collector(params, vehicle), truth_(truth) {}

  Result<Observation> keep(Observation observation) override {
    collector.add(observation);
    T_world_vehicle.push_back(truth_.truth().T_world_vehicle);
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

  RoomRunCollector collector;
  std::vector<Pose2> T_world_vehicle;

 private:
  const TruthSource& truth_;
};

Result<std::shared_ptr<const TaughtRoute>> teach_route(const SimulationSetting& setting,
                                                       const WorldRoute& world_route,
                                                       const RoomTrialParams& params, std::uint64_t seed,
                                                       Progress& progress) {
  SimulationSetting taught = setting;
  keep_cameras(taught.vehicle.description, {kFirstCamera});
  const bool shows_pattern = params.view_pattern && world_route.parking == ParkingStrategy::kView;
  RouteGuide person(taught.world, world_route, taught.vehicle.description, {}, seed,
                    shows_pattern ? ShownViews::kPattern : ShownViews::kTrail);
  SimulatedVehicle vehicle(taught.world, taught.vehicle, {},
                           {.seed = seed, .T_world_start = start_of(world_route)}, &person);
  HandDriver driver({});
  RoomRunRecord record(params.learner, vehicle.description(), vehicle);
  const auto end = run_mission(vehicle, driver, record, progress);
  if (!end) return end.problems();
  if (!person.has_arrived())
    return Problem{{setting.world_file.string(), 0, world_route.name}, "the person did not get through"};
  auto learned =
      learn_room(record.collector.cycles, taught.vehicle.description, world_route.name, params.learner);
  if (!learned) return learned.problems();
  Route route = std::move(learned->building.routes.front());
  RouteInWorld place(MapTruth(std::move(learned->T_route_vehicle), std::move(record.T_world_vehicle)), route);
  return std::make_shared<const TaughtRoute>(TaughtRoute{std::move(route), std::move(place)});
}

}  // namespace

Result<std::shared_ptr<const TaughtRoute>> TaughtRoutes::taught(const SimulationSetting& setting,
                                                                const WorldRoute& world_route,
                                                                std::uint64_t seed, Progress& progress) {
  const std::string key = setting.world_file.string() + "/" + setting.world.name + "/" + world_route.name;
  auto known = by_first_seed_.find(key);
  if (known == by_first_seed_.end())
    known =
        by_first_seed_.emplace(key, teach_route(setting, world_route, params_, first_seed_, progress)).first;
  if (known->second || seed == first_seed_) return known->second;
  return teach_route(setting, world_route, params_, seed, progress);
}

}  // namespace aisle
