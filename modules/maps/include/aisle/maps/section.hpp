#pragma once
/// A taught path as a list of sections, each with a path of its own (L03 sections 3 and 4).

#include <optional>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Turns on the spot are multiples of this (L03 Table 2).
inline constexpr double kTurnQuantum_rad = 2.5 * kDegree;

struct Section {
  enum class Kind {
    kFollow,  ///< a: straight on along a wall-floor edge
    kHybrid,  ///< h: the same until the edge leaves the view, then by odometry up to a right turn
    kDead,    ///< d: straight across a corridor by odometry, with no edge to follow
    kCurve,   ///< c: around a left corner on a parabola
    kTurn,    ///< l, r: on the spot
    kBack,    ///< b: straight back
  };
  Kind kind = Kind::kFollow;
  double length_m = 0;              ///< all but kCurve and kTurn; > 0, also for kBack
  double turn_rad = 0;              ///< kTurn: left positive, a multiple of the quantum
  Vec2 p_start_end = Vec2::Zero();  ///< kCurve: P2 as seen from P1, x ahead, y left; both > 0
  std::optional<double> right_m;    ///< kFollow, kHybrid: mean distance to the right wall-floor edge
  std::optional<double> left_m;     ///< and to the left one
  std::optional<double> ahead_m;    ///< kFollow, kHybrid: from its end to the wall across the path

  bool is_straight() const { return kind != Kind::kCurve && kind != Kind::kTurn; }
  friend bool operator==(const Section&, const Section&) = default;
};

using SectionList = std::vector<Section>;

/// The vertices of a corner's parabola (L03 section 4.2), seen from its start, x ahead, y left. The curve has
/// its apex at the end. From one vertex to the next the chord's direction is a multiple of the turn quantum,
/// the first that the curve reaches. Without the start, with the end.
std::vector<Vec2> curve_vertices(const Vec2& p_start_end);

/// The path of a list: straight lines and turns on the spot. A curve turns to its parabola's direction, goes
/// through the vertices on arcs, and ends a quarter turn left of where it began.
/// @param piece_sections  if not null: filled with the section of each piece of the path
Path path_of(const SectionList& sections, const Pose2& T_map_start,
             std::vector<std::size_t>* piece_sections = nullptr);

}  // namespace aisle
