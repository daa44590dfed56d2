#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Outlines of the world at a height above the floor [m], without people: what a range scanner at that height
/// sees. Outlines of solid objects have their outside on the left.
std::vector<Segment2> cross_section(const World& world, double height_m);

/// What a vehicle can hit: the outlines of everything between the floor and a height [m].
std::vector<Segment2> obstacles_below(const World& world, double height_m);

}  // namespace aisle
