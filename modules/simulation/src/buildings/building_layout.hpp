#pragma once

#include <string>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/world.hpp"
#include "buildings/rectangle_union.hpp"

namespace aisle {

/// A room behind a door to a corridor.
struct Room {
  Rectangle floor;
  Rectangle doorway;            ///< through the wall, as deep as the wall
  Vec2 inwards = Vec2::Zero();  ///< from the doorway into the room, of length 1
  bool is_open = false;         ///< a vehicle can enter
  bool has_leaf = true;         ///< else an opening without a door
};

/// The floor of a random building, before anything stands in it.
struct BuildingLayout {
  std::vector<Rectangle> corridors;  ///< and halls; they overlap where they meet
  std::vector<Rectangle> alcoves;
  std::vector<Room> rooms;
  std::vector<NamedPlace> places;  ///< ends of corridors and the like
  std::vector<Vec2> tour;          ///< along the middles of all corridors and back
  double wall_thickness_m = 0.2;

  /// Everything that is free floor.
  std::vector<Rectangle> floor() const;
};

/// Corridors and halls with their tour.
BuildingLayout random_corridors(const RandomBuildingRecipe& recipe, Random& random);

/// Lines the walls of the corridors with rooms and alcoves.
void add_rooms(BuildingLayout& layout, Random& random);

/// Rounded to centimetres, uniform between the two.
double random_centimetres(Random& random, double min_m, double max_m);

/// True with this probability.
bool with_probability(Random& random, double probability);

}  // namespace aisle
