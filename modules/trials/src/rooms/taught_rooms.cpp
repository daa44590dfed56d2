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

Result<TaughtRoute> teach_route(const SimulationSetting& setting, const WorldRoute& world_route,
                                const RoomTrialParams& params, std::uint64_t seed, Progress& progress) {
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
  return TaughtRoute{std::move(route), std::move(place)};
}

}  // namespace

Result<const TaughtRoute*> TaughtRoutes::taught(const SimulationSetting& setting,
                                                const WorldRoute& world_route, std::uint64_t seed,
                                                Progress& progress) {
  const std::string key = setting.world_file.string() + "/" + setting.world.name + "/" + world_route.name;
  auto known = taught_.find(key);
  if (known == taught_.end()) {
    auto route =
        teach_route(setting, world_route, params_, refused_.contains(key) ? seed : first_seed_, progress);
    if (!route) {
      refused_.insert(key);
      return route.problems();
    }
    known = taught_.emplace(key, std::move(*route)).first;
  }
  return &known->second;
}

}  // namespace aisle
