#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle {

/// Which small obstacles count as legs of one piece of furniture.
struct LegParams {
  double leg_max_m = 0.2;    ///< greatest apparent width of a leg, blur included
  double apart_max_m = 2;    ///< legs within this of each other carry one piece of furniture
  double plate_min_m = 0.6;  ///< under smaller pieces no vehicle fits ...
  double wall_max_m = 0.95;  ///< ... larger ones may have their back legs this near to a wall

  void describe(FieldList& fields);
};

/// A scan at one height shows the legs of tables and chairs, not their tops. Groups of small obstacles are
/// taken for legs, and the floor between them is closed. So is the floor between a wall and two legs in front
/// of it, where a table has its back to the wall, and between one such leg and the other, which may be hidden
/// behind floor not seen yet. A small obstacle at a wall may be a speck of the wall. It is a leg only right
/// before the wall, two cells out if it is connected to the wall, or at the end of a wall that is also behind
/// the other leg; and only paired with one that is free-standing and has it in full view, or that is right
/// before the opposite wall of a recess that the table fills. One of many in a row on the line of a long wall
/// is part of that wall, seen from far or at a grazing angle. Nothing is closed where the vehicle has been.
class LegBarriers {
 public:
  explicit LegBarriers(const LegParams& params = {}) : params_(params) {}

  /// Call this when cells of the box may have changed. O(obstacles within 8 m of the box), plus one pass over
  /// all.
  /// @return a box around all cells that were closed or opened
  FloorBox update(const FloorGrid& floor, const FloorBox& changed);

  bool is_closed(FloorCell cell) const;
  /// Row by row; a cell closed by several pairs is listed several times.
  std::span<const FloorCell> closed() const { return closed_; }
  std::size_t legs() const;

 private:
  /// Where a small obstacle is. Unclear: it may be part of a wall of which little was seen.
  enum class Stand : std::uint8_t { kFree, kBeforeWall, kUnclear };
  struct Obstacle {
    Vec2 p_map;                     ///< its centre
    Vec2 behind = Vec2::Zero();     ///< unit vector towards what it is right in front of
    std::vector<Vec2> walls;        ///< positions in `map` of nearby obstacles that are no legs
    std::vector<FloorCell> closes;  ///< between it and later or hidden partners; row by row
    FloorCell first;                ///< its lowest cell; of several, the leftmost
    Stand stand = Stand::kUnclear;
    bool is_of_wall = false;  ///< part of a wall
    bool is_leg() const { return stand != Stand::kUnclear && !is_of_wall; }
    bool is_free_leg() const { return stand == Stand::kFree && !is_of_wall; }
  };

  int leg_cells(const FloorGrid& floor) const;
  std::vector<FloorCell> small_obstacle(const FloorGrid& floor, FloorCell start) const;
  std::optional<Obstacle> leg_of_wall(const FloorGrid& floor, FloorCell first) const;
  /// Sets `stand` and `behind`.
  void look_about(const FloorGrid& floor, Obstacle& obstacle) const;
  std::vector<FloorCell> find_obstacles(const FloorGrid& floor, const FloorBox& within);
  bool is_piece_of_wall(const FloorGrid& floor, const Obstacle& obstacle) const;
  void find_walls(const FloorGrid& floor, Obstacle& obstacle) const;
  std::span<const Obstacle> obstacles_around(const FloorGrid& floor, const Vec2& p_map,
                                             double within_m) const;
  bool is_leg(const FloorGrid& floor, const Vec2& p_map) const;
  bool is_small_obstacle(const FloorGrid& floor, const Vec2& p_map) const;
  FloorBox close_again(const FloorGrid& floor, std::span<const FloorBox> boxes,
                       std::vector<FloorCell> opened);
  std::vector<FloorCell> cells_closed_by(const FloorGrid& floor, std::size_t first) const;
  bool fill_recess(const FloorGrid& floor, const Obstacle& a, const Obstacle& b) const;
  bool may_carry_one_plate(const FloorGrid& floor, const Obstacle& a, const Obstacle& b) const;
  bool stands_along_wall(const FloorGrid& floor, const Obstacle& leg, const Obstacle& obstacle) const;
  std::optional<Vec2> wall_behind(const Obstacle& leg, const Vec2& along) const;
  template <class Matters>
  std::optional<Vec2> nearest_wall(const Obstacle& leg, Matters matters) const;
  Vec2 across_wall(const Obstacle& leg, const Vec2& p_map_nearest) const;
  bool wall_goes_on(const FloorGrid& floor, const Vec2& p_map_leg, const Vec2& away) const;
  std::vector<Vec2> hidden_partners(const FloorGrid& floor, const Obstacle& leg) const;
  bool has_partner(const FloorGrid& floor, const Obstacle& leg, const Vec2& along) const;
  std::optional<Vec2> partner_place(const FloorGrid& floor, const Vec2& p_map_leg, const Vec2& along) const;

  LegParams params_;
  std::vector<Obstacle> obstacles_;  ///< row by row
  std::vector<FloorCell> closed_;    ///< row by row, once for each obstacle that closes it
};

}  // namespace aisle
