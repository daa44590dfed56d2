#pragma once
/// The navigator of taught paths through rooms as missions and their replays make it: both from the origin
/// that the session records.

#include <memory>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

inline constexpr const char* kRoomNavigator = "route";  ///< as a session's navigator

struct RoomDriverParams {
  RoomNavigatorParams navigator;
  double from_m = 0;

  void describe(FieldList& fields) {
    navigator.describe(fields);
    fields.real("from_m", from_m, {0, 100'000}, "along the route, where the vehicle is set down");
  }
};

/// The building's route of a name, which was taught in a room; an empty name means the first route.
Result<Route> find_room_route(const Building& building, const std::string& name);

/// The other cameras stay off.
void keep_cameras(VehicleDescription& vehicle, const std::vector<std::string>& names);

/// Problems: parameters and building that cannot be read, an unknown route, one that was not taught in a
/// room, a vehicle that is not front-steered or lacks a camera.
Result<std::unique_ptr<RoomNavigator>> make_room_navigator(const SessionOrigin& origin,
                                                           const VehicleDescription& vehicle);

/// What keeps a vehicle from driving through rooms by these cameras; empty: nothing.
Problems unfit_for_rooms(const VehicleDescription& vehicle, const std::vector<std::string>& cameras);

}  // namespace aisle
