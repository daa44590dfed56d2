#pragma once
/// Every key of a world file, object by object.

#include <vector>

#include "aisle/simulation/world.hpp"
#include "file_limits.hpp"
#include "object_fields.hpp"

namespace aisle {

inline constexpr Range kCoordinate_m = {-kCoordinateMax_m, kCoordinateMax_m};

/// Consecutive wall faces.
struct WallLine {
  std::vector<Vec2> line;
  double height_m = 0;  ///< 0: up to the ceiling
  double brightness = WallFace{}.brightness;
  double returns = WallFace{}.returns;
};

ObjectFields fields_of(WallLine& wall);
ObjectFields fields_of(Door& door);
ObjectFields fields_of(Poster& poster);
ObjectFields fields_of(Lamp& lamp);
ObjectFields fields_of(FloorCovering& floor);
ObjectFields fields_of(FloorPaper& paper);
ObjectFields fields_of(Furniture& piece);
ObjectFields fields_of(ParkingFrame& frame);
ObjectFields fields_of(CalibrationBoard& board);
ObjectFields fields_of(Person& person);
ObjectFields fields_of(NamedPlace& place);
ObjectFields fields_of(WorldRoute& route);
ObjectFields fields_of(TaughtTurning& turning);
ObjectFields fields_of(Pose2& pose);

/// The single values of a world: name, tour, ceiling, skirting, light.
ObjectFields fields_of(World& world);

inline constexpr std::size_t kObjectsMax = 50'000;

/// The lists of a world and the maximum length of each: visit(key, objects, most).
template <class SomeWorld, class Visit>
void for_each_list(SomeWorld& world, const Visit& visit) {
  constexpr std::size_t kFew = 1'000, kPeopleMax = 200;
  visit("doors", world.doors, kObjectsMax);
  visit("posters", world.posters, kObjectsMax);
  visit("lamps", world.lamps, kObjectsMax);
  visit("papers", world.papers, kObjectsMax);
  visit("furniture", world.furniture, kObjectsMax);
  visit("parking_frames", world.parking_frames, kFew);
  visit("boards", world.boards, kFew);
  visit("people", world.people, kPeopleMax);
  visit("places", world.places, kFew);
  visit("routes", world.routes, kFew);
  visit("turnings", world.turnings, kObjectsMax);
}

}  // namespace aisle
