#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Outlines of the world at a height above the floor [m], without people: what a range scanner at that height
/// sees. Outlines of solid objects have their outside on the left.
std::vector<Segment2> cross_section(const World& world, double height_m);

/// A part of that outline which sends back only a share of a scanner's beams.
struct FaintOutline {
  Segment2 segment;
  double returns = 1;     ///< share, < 1
  bool is_glass = false;  ///< the other beams go through; else they are lost
};

/// The faint parts of the outlines, and the others.
struct SeenOutlines {
  std::vector<Segment2> clear;
  std::vector<FaintOutline> faint;
};
SeenOutlines seen_outlines(const World& world, double height_m);

/// What a vehicle can hit: the outlines of everything between the floor and a height [m].
std::vector<Segment2> obstacles_below(const World& world, double height_m);

}  // namespace aisle
