#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle {

/// Which small things bound one obstacle.
struct LegParams {
  double leg_max_m = 0.2;    ///< as wide as a leg may seem, with all that blurs it
  double apart_max_m = 2;    ///< legs so near to each other carry one piece of furniture
  double plate_min_m = 0.6;  ///< under smaller pieces no vehicle fits ...
  double wall_max_m = 0.95;  ///< ... larger ones may stand with their back legs so near to a wall

  void describe(FieldList& fields);
};

/// A scan at one height shows the legs of tables and chairs, not their tops. Small things that stand in
/// groups are taken for legs, and what lies between them for closed; so is the path in between a wall and
/// two legs before it, where a table stands with its back to the wall, and from one such leg to the other,
/// be it a small thing or hidden by floor not seen yet. What stands at a wall may be a speck of it: it is a
/// leg only right before the wall, standing two cells out of it where it hangs together with it, or at the
/// end of one with the same wall behind it as behind the other leg, and only to one that stands free and has
/// it in full view, or that stands right before the wall across the recess that a table fills. One of many in
/// a row on the line of a long wall is a piece of it, seen from afar or along it. No plate is where the
/// vehicle stood.
class LegBarriers {
 public:
  explicit LegBarriers(const LegParams& params = {}) : params_(params) {}

  /// The cells of the box may have changed. O(what stands within 8 m of the box), but for passing over all.
  /// @return where it is closed now and was not, or the other way round
  FloorBox update(const FloorGrid& floor, const FloorBox& changed);

  bool is_closed(FloorCell cell) const;
  /// Row by row; a cell that several pairs close stands there as often.
  std::span<const FloorCell> closed() const { return closed_; }
  std::size_t legs() const;

 private:
  /// Where a small thing stands. Unclear: it may be a piece of a wall of which little was seen.
  enum class Stand : std::uint8_t { kFree, kBeforeWall, kUnclear };
  struct Thing {
    Vec2 p_map;                     ///< its middle
    Vec2 behind = Vec2::Zero();     ///< a unit towards what it stands right before
    std::vector<Vec2> walls;        ///< places in `map` near it where something stands that is no leg
    std::vector<FloorCell> closes;  ///< between it and what follows it, or hides; row by row
    FloorCell first;                ///< its lowest cell, the leftmost of these
    Stand stand = Stand::kUnclear;
    bool is_of_wall = false;  ///< one of its pieces
    bool is_leg() const { return stand != Stand::kUnclear && !is_of_wall; }
    bool is_free_leg() const { return stand == Stand::kFree && !is_of_wall; }
  };

  int leg_cells(const FloorGrid& floor) const;
  std::vector<FloorCell> small_thing(const FloorGrid& floor, FloorCell start) const;
  std::optional<Thing> leg_of_wall(const FloorGrid& floor, FloorCell first) const;
  /// Tells its stand, and behind.
  void look_about(const FloorGrid& floor, Thing& thing) const;
  std::vector<FloorCell> find_things(const FloorGrid& floor, const FloorBox& within);
  bool is_piece_of_wall(const FloorGrid& floor, const Thing& thing) const;
  void find_walls(const FloorGrid& floor, Thing& thing) const;
  std::span<const Thing> things_about(const FloorGrid& floor, const Vec2& p_map, double within_m) const;
  bool is_leg(const FloorGrid& floor, const Vec2& p_map) const;
  bool is_thing(const FloorGrid& floor, const Vec2& p_map) const;
  FloorBox close_again(const FloorGrid& floor, std::span<const FloorBox> boxes,
                       std::vector<FloorCell> opened);
  std::vector<FloorCell> cells_closed_by(const FloorGrid& floor, std::size_t first) const;
  bool fill_recess(const FloorGrid& floor, const Thing& a, const Thing& b) const;
  bool may_carry_one_plate(const FloorGrid& floor, const Thing& a, const Thing& b) const;
  bool stands_along_wall(const FloorGrid& floor, const Thing& leg, const Thing& thing) const;
  std::optional<Vec2> wall_behind(const Thing& leg, const Vec2& along) const;
  template <class Matters>
  std::optional<Vec2> nearest_wall(const Thing& leg, Matters matters) const;
  Vec2 across_wall(const Thing& leg, const Vec2& p_map_nearest) const;
  bool wall_goes_on(const FloorGrid& floor, const Vec2& p_map_leg, const Vec2& away) const;
  std::vector<Vec2> hidden_partners(const FloorGrid& floor, const Thing& leg) const;
  bool has_partner(const FloorGrid& floor, const Thing& leg, const Vec2& along) const;
  std::optional<Vec2> partner_place(const FloorGrid& floor, const Vec2& p_map_leg, const Vec2& along) const;

  LegParams params_;
  std::vector<Thing> things_;      ///< row by row
  std::vector<FloorCell> closed_;  ///< row by row, as often as things close it
};

}  // namespace aisle
