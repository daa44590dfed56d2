#include "rooms/room_lesson.hpp"

#include <utility>

#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/vision/places/brightness_view.hpp"
#include "aisle/vision/places/column_view.hpp"
#include "rooms/room_driver.hpp"
#include "sessions/session_trip.hpp"

namespace aisle {

RoomTripCollector::RoomTripCollector(const RoomLessonParams& params, const VehicleDescription& vehicle)
    : params_(params),
      vehicle_(vehicle),
      camera_(room_camera(vehicle, kFirstCamera)),
      view_(params.view, camera_.intrinsics, camera_.mount, camera_.width_px, camera_.height_px,
            vehicle.footprint.width_m, stripe_height_m(vehicle)) {}

void RoomTripCollector::add(const Observation& observation) {
  RoomCycle cycle{.stamp_s = observation.stamp_s,
                  .odometry = observation.odometry,
                  .marks = observation.operator_input.marks,
                  .patch = {},
                  .p_vehicle_painted = {},
                  .view = {},
                  .p_vehicle_edges = {}};
  if (const CameraPicture* picture = present_picture(observation, camera_.name, vehicle_.cycle_s)) {
    const RouteSight& sight = view_.look(*picture->image);
    if (!std::exchange(has_patch_, true))
      cycle.patch = RouteBrightness{sight.patch_grey, sight.patch_deviation};
    cycle.p_vehicle_edges = sight.p_vehicle_edges;
    cycle.view = PlaceView{brightness_view(*picture->image), column_view(*picture->image)};
    cycle.p_vehicle_painted = painted_line_points(*picture->image, CameraModel(camera_.intrinsics),
                                                  camera_.mount, params_.learning.frame);
  }
  cycles.push_back(std::move(cycle));
}

Result<std::vector<RoomCycle>> read_room_trip(const std::filesystem::path& session, SessionCycles& cycles,
                                              const RoomLessonParams& params, Progress& progress) {
  Problems problems = unfit_for_rooms(cycles.vehicle(), {kFirstCamera});
  for (Problem& problem : problems) problem.where.file = session.string();
  if (!problems.empty()) return problems;
  RoomTripCollector collector(params, cycles.vehicle());
  const auto pictures = take_observations(
      session, cycles, progress, [&](const Observation& observation) { collector.add(observation); });
  if (!pictures) return pictures.problems();
  if (*pictures == 0) return Problem{{session.string()}, "has no pictures"};
  return std::move(collector.cycles);
}

Result<RoomLesson> learn_room(const std::vector<RoomCycle>& cycles, const VehicleDescription& vehicle,
                              const std::string& route, const RoomLessonParams& params) {
  auto learned = learn_room_route(cycles, vehicle, params.learning);
  if (!learned) return learned.problems();
  RoomLesson lesson{.building = {}, .T_route_vehicle = std::move(learned->T_route_vehicle)};
  learned->route.name = route;
  lesson.building.name = route;
  lesson.building.routes.push_back(std::move(learned->route));
  return lesson;
}

}  // namespace aisle
