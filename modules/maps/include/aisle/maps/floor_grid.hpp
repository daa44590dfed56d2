#pragma once
/// The floor of a building as it was seen: an occupancy grid of square cells in the frame `map`, at one
/// height above the floor.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

enum class Floor : std::uint8_t { kUnknown, kFree, kOccupied };

/// Column and row. Cell (0, 0) has its lower left corner at the origin of `map`; both may be negative.
struct FloorCell {
  int x = 0;
  int y = 0;
  bool operator==(const FloorCell&) const = default;
  /// Row by row from the bottom, each from the left.
  bool operator<(const FloorCell& other) const { return y != other.y ? y < other.y : x < other.x; }
};

/// Cells from `low` up to but not including `end`, in x and y.
struct FloorBox {
  FloorCell low;
  FloorCell end;

  bool empty() const { return low.x >= end.x || low.y >= end.y; }
  bool contains(FloorCell cell) const {
    return cell.x >= low.x && cell.x < end.x && cell.y >= low.y && cell.y < end.y;
  }
  /// Grows to the smallest box that contains this one and the cell.
  void include(FloorCell cell);
  /// Grows to the smallest box that contains both.
  void include_box(const FloorBox& other);
  FloorBox widened(int cells) const;
  /// The intersection; empty if there is none.
  FloorBox common_with(const FloorBox& other) const;
};

/// Free, occupied and unknown floor. It grows in all directions as it is filled; everything beyond is
/// unknown. Each cell weighs its evidence: one hit outweighs a few views that pass through, and what has gone
/// away fades.
///
/// What is solid where the floor was surely seen to be free is a dynamic obstacle, such as a person: its
/// second hit makes the cell occupied, each view that passes undoes one hit, and what is not hit for
/// `kForgotten_s` is forgotten. What was hit often has come to stay.
class FloorGrid {
 public:
  /// Cells farther from the origin than this, in columns or rows, are never kept.
  static constexpr int kReach = 8192;
  /// As long as costmaps for robots among people keep what they do not see (10 to 20 s).
  static constexpr double kForgotten_s = 15;

  /// @param cell_m  > 0, else std::invalid_argument
  explicit FloorGrid(double cell_m = 0.05);

  double cell_m() const { return cell_m_; }
  FloorCell cell_at(const Vec2& p_map) const {
    return {column_of(p_map.x() / cell_m_), column_of(p_map.y() / cell_m_)};
  }
  Vec2 centre(FloorCell cell) const { return {(cell.x + 0.5) * cell_m_, (cell.y + 0.5) * cell_m_}; }

  Floor at(FloorCell cell) const { return floor_of(evidence(cell)); }
  Floor at(const Vec2& p_map) const { return at(cell_at(p_map)); }

  /// A view passed through the cell / hit something in it.
  /// @return whether the cell's state has changed
  bool see_free(FloorCell cell);
  bool see_occupied(FloorCell cell);
  /// The same, and a beam beside it hits about there, too: a dynamic obstacle, if the floor was surely free
  /// and nothing stands beside the cell. Thin things and glass, which send back single beams, were there
  /// before.
  bool see_solid(FloorCell cell);
  /// Nothing was hit there, but something thin may have been missed: an earlier hit stays, and a single new
  /// one outweighs this.
  /// @return whether the cell's state has changed
  bool seem_free(FloorCell cell);
  /// The same from a new place, where something thin would have been hit more often than not: what was hit
  /// earlier fades.
  bool fade(FloorCell cell);
  /// From now on, hits are of this time, which does not go back. Dynamic obstacles that were not hit for
  /// `kForgotten_s` are forgotten.
  /// @return a box around all cells whose state has changed
  FloorBox pass_time(double stamp_s);
  /// All dynamic obstacles are forgotten.
  /// @return as `pass_time`
  FloorBox forget_dynamic();
  /// Whether a dynamic obstacle was hit there.
  bool is_dynamic(FloorCell cell) const { return evidence(cell) > kSurelyOccupied; }
  /// The vehicle is on the cell: nothing is there, at any height. Kept until something is hit in it; an
  /// occupied cell counts as one that a view passed through.
  /// @return whether the cell's state has changed, or the vehicle was not on it before
  bool stand_on(FloorCell cell);
  bool was_stood_on(FloorCell cell) const { return evidence(cell) == kStoodOn; }
  /// Sets the cell with the strongest evidence.
  void set(FloorCell cell, Floor floor);

  /// A box that contains every cell that is not unknown.
  const FloorBox& known() const { return known_; }
  std::size_t count(Floor floor) const { return counts_[static_cast<std::size_t>(floor)]; }
  double free_m2() const { return static_cast<double>(count(Floor::kFree)) * cell_m_ * cell_m_; }

  void clear();

 private:
  using Evidence = std::int8_t;  ///< 0: never seen; above: occupied; below: free
  static constexpr Evidence kStoodOn = -100;
  static constexpr Evidence kSurelyOccupied = 16;
  /// Above kSurelyOccupied: hits of a dynamic obstacle, less views that passed since.
  static constexpr Evidence kDynamicOnce = kSurelyOccupied + 1;

  static int column_of(double coordinate_cells) {
    constexpr double kLimit = kReach + 1;
    return static_cast<int>(std::floor(std::clamp(coordinate_cells, -kLimit, kLimit)));
  }
  static Floor floor_of(Evidence evidence) {
    if (evidence == 0) return Floor::kUnknown;
    return evidence > 0 && evidence != kDynamicOnce ? Floor::kOccupied : Floor::kFree;
  }
  std::size_t index(FloorCell cell) const {
    return static_cast<std::size_t>(cell.y - stored_.low.y) *
               static_cast<std::size_t>(stored_.end.x - stored_.low.x) +
           static_cast<std::size_t>(cell.x - stored_.low.x);
  }
  Evidence evidence(FloorCell cell) const {
    return stored_.contains(cell) ? evidence_[index(cell)] : Evidence{0};
  }
  static Evidence weighed(int evidence, int weight);
  bool is_beside_standing(FloorCell cell) const;
  bool weigh(FloorCell cell, int weight);
  bool put_dynamic(FloorCell cell, Evidence evidence);
  FloorBox forget_dynamic_before(double hit_s);
  bool put(FloorCell cell, Evidence evidence);
  void grow_to(FloorCell cell);

  double cell_m_;
  FloorBox stored_;  ///< the cells in `evidence_`, row by row
  FloorBox known_;
  std::vector<Evidence> evidence_;
  std::size_t counts_[3] = {};                 ///< of `evidence_`, by Floor; unknown ones are not counted
  std::map<FloorCell, double> dynamic_hit_s_;  ///< time of the last hit
  double now_s_ = 0;
};

}  // namespace aisle
