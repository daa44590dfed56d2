#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// What stands in the world at a height above the floor [m], people excepted: what a range scanner at that
/// height sees. Outlines of solid things run with their outside on the left.
std::vector<Segment2> cross_section(const World& world, double height_m);

/// What is in the path of a vehicle: everything that stands anywhere between the floor and the height.
std::vector<Segment2> obstacles_below(const World& world, double height_m);

}  // namespace aisle
