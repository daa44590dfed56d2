#include "aisle/missions/rooms/room_learning_result.hpp"

#include <utility>

#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/missions/taught_session.hpp"
#include "aisle/vision/places/brightness_view.hpp"
#include "aisle/vision/places/column_view.hpp"

namespace aisle {

RoomRunCollector::RoomRunCollector(const RoomLearnerParams& params, const VehicleDescription& vehicle)
    : params_(params),
      vehicle_(vehicle),
      camera_(room_camera(vehicle, kFirstCamera)),
      view_(params.view, camera_.intrinsics, camera_.mount, camera_.width_px, camera_.height_px,
            vehicle.footprint.width_m, stripe_height_m(vehicle)) {}

void RoomRunCollector::add(const Observation& observation) {
  RoomCycle cycle{.stamp_s = observation.stamp_s,
                  .odometry = observation.odometry,
                  .marks = observation.operator_input.marks,
                  .patch = {},
                  .p_vehicle_painted = {},
                  .view = {},
                  .p_vehicle_edges = {}};
  if (const CameraImage* image = present_image(observation, camera_.name, vehicle_.cycle_s)) {
    const RouteSight& sight = view_.look(*image->pixels);
    if (!std::exchange(has_patch_, true))
      cycle.patch = RouteBrightness{sight.patch_grey, sight.patch_deviation};
    cycle.p_vehicle_edges = sight.p_vehicle_edges;
    cycle.view = PlaceView{brightness_view(*image->pixels), column_view(*image->pixels)};
    cycle.p_vehicle_painted = painted_line_points(*image->pixels, CameraModel(camera_.intrinsics),
                                                  camera_.mount, params_.learning.frame);
  }
  cycles.push_back(std::move(cycle));
}

Result<std::vector<RoomCycle>> read_room_run(const std::filesystem::path& session, SessionCycles& cycles,
                                             const RoomLearnerParams& params, Progress& progress) {
  if (Problems lacking = check_for_learning(session, cycles.origin()); !lacking.empty()) return lacking;
  Problems problems = unfit_for_rooms(cycles.vehicle(), {kFirstCamera});
  for (Problem& problem : problems) problem.where.file = session.string();
  if (!problems.empty()) return problems;
  RoomRunCollector collector(params, cycles.vehicle());
  const auto images = take_observations(session, cycles, progress,
                                        [&](const Observation& observation) { collector.add(observation); });
  if (!images) return images.problems();
  if (*images == 0) return Problem{{session.string()}, "has no images"};
  return std::move(collector.cycles);
}

Result<RoomLearningResult> learn_room(const std::vector<RoomCycle>& cycles, const VehicleDescription& vehicle,
                                      const std::string& route, const RoomLearnerParams& params) {
  auto learned = learn_room_route(cycles, vehicle, params.learning);
  if (!learned) return learned.problems();
  RoomLearningResult result{.building = {}, .T_route_vehicle = std::move(learned->T_route_vehicle)};
  learned->route.name = route;
  result.building.name = route;
  result.building.routes.push_back(std::move(learned->route));
  return result;
}

}  // namespace aisle
