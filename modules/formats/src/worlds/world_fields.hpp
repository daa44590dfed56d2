#pragma once
/// Every key of a world file, object by object. Each is listed once: the reader, the writer and the test of
/// the documentation iterate over these lists.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/simulation/world.hpp"
#include "file_limits.hpp"

namespace aisle {

inline constexpr Range kCoordinate_m = {-kCoordinateMax_m, kCoordinateMax_m};

/// A point of an object, wherever its two or three coordinates are stored.
struct PointTarget {
  std::vector<double*> coordinates;
};

/// One of a few words.
struct WordTarget {
  std::span<const std::string_view> words;
  std::function<std::size_t()> index;
  std::function<void(std::size_t)> choose;
};

using WorldTarget =
    std::variant<double*, int*, std::uint64_t*, PointTarget, std::vector<Vec2>*, std::string*, WordTarget>;

/// One key of an object and the variable that it sets.
struct WorldField {
  std::string_view key;
  WorldTarget target;
  Range range;            ///< of each number, inclusive, in the key's unit
  double inner_unit = 1;  ///< the variable is the key's value times this (degrees -> radians)
  bool is_needed = false;
};

/// Valid as long as the object lives.
using WorldFields = std::vector<WorldField>;

/// Consecutive wall faces.
struct WallLine {
  std::vector<Vec2> line;
  double height_m = 0;  ///< 0: up to the ceiling
  double brightness = WallFace{}.brightness;
};

WorldFields fields_of(WallLine& wall);
WorldFields fields_of(Door& door);
WorldFields fields_of(Poster& poster);
WorldFields fields_of(Lamp& lamp);
WorldFields fields_of(FloorCovering& floor);
WorldFields fields_of(FloorPaper& paper);
WorldFields fields_of(Furniture& piece);
WorldFields fields_of(ParkingFrame& frame);
WorldFields fields_of(CalibrationBoard& board);
WorldFields fields_of(Person& person);
WorldFields fields_of(NamedPlace& place);
WorldFields fields_of(WorldRoute& route);
WorldFields fields_of(TaughtTurning& turning);
WorldFields fields_of(Pose2& pose);

/// The single values of a world: name, tour, ceiling, skirting, light.
WorldFields fields_of(World& world);

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
