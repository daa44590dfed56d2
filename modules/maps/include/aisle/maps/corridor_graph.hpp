#pragma once
/// The graph of an explored building as C99 leaves it: crossings, ends, and the corridors between them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct CorridorNode {
  enum class Kind {
    kCrossing,  ///< three or more corridors meet
    kEnd,       ///< one corridor ends
    kRound,     ///< any point of a loop corridor without a crossing
  };
  Kind kind = Kind::kEnd;
  Vec2 p_map = Vec2::Zero();
};

/// "crossing", "end" or "round".
std::string_view name_of(CorridorNode::Kind kind);

struct Corridor {
  std::size_t from = 0;    ///< node where it starts
  std::size_t to = 0;      ///< node where it ends; equal to `from` in a loop
  std::vector<Vec2> path;  ///< its centre line in `map`, from node to node; at least two points
  double width_m = 0;      ///< between its walls, median of what was measured along it

  double length_m() const;
  /// The point at a distance from the start, clamped to 0 .. length_m().
  Vec2 at(double along_m) const;
};

/// A place on a corridor.
struct CorridorPlace {
  std::size_t corridor = 0;
  double along_m = 0;  ///< from the corridor's start
  Vec2 p_map = Vec2::Zero();
  double lateral_m = 0;  ///< distance from there to the point that was asked for, >= 0
};

struct CorridorGraph {
  std::vector<CorridorNode> nodes;
  std::vector<Corridor> corridors;

  /// Total length of all corridors [m].
  double length_m() const;
  std::size_t count(CorridorNode::Kind kind) const;
  /// How many corridors end at a node; a loop counts twice.
  std::size_t degree(std::size_t node) const;

  /// The place on a corridor nearest to a point, the first of equally near ones; nullopt without corridors.
  std::optional<CorridorPlace> nearest(const Vec2& p_map) const;
  /// A node as a place on one of its corridors; nullopt if no corridor ends there.
  std::optional<CorridorPlace> place_of(std::size_t node) const;

  /// "crossing 2", "end 1", "round 1": the nodes of each kind are counted from 1 in their order.
  std::string name_of(std::size_t node) const;
};

}  // namespace aisle
