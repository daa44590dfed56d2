#include "aisle/maps/floor_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "aisle/maps/occupied_near.hpp"

namespace aisle {
namespace {

constexpr double kHitFrom = 0.25;  // cells beyond the footprint: a bumper contact is entered from here ...
constexpr double kHitTo = 1.5;     // ... to here
constexpr double kSurelyInside_m = 0.05;  // inside the footprint: the pose may be off
constexpr double kCoarse = 1.5;           // cells by which a hit may be off
constexpr double kWallGap_m = 0.3;        // a wall may go on unseen this far from a hit
constexpr double kThin_m = 0.04;          // a table's leg: beams farther apart may miss it
// From new places, beams this far apart miss it in three views of five. A hit weighs four misses: it stays,
// and only what has gone away fades.
constexpr double kOftenHit_m = 2.5 * kThin_m;
constexpr double kSolid_m = 0.15;      // in range, from beam to beam of one thing
constexpr double kLostAcross_m = 0.3;  // no opening is so narrow: beams in between were absorbed

/// The cells that a disc or rectangle around a place may touch.
FloorBox box_around(const FloorGrid& floor, const Vec2& p_map, double reach_m) {
  FloorBox box;
  box.include(floor.cell_at(p_map.array() - reach_m));
  box.include(floor.cell_at(p_map.array() + reach_m));
  return box;
}

class FloorPainter {
 public:
  /// @param free_to_m  one a beam: floor beyond is not shown to be free
  FloorPainter(FloorGrid& floor, const LaserScanner& laser, std::span<const float> ranges_m,
               std::span<const float> free_to_m, std::span<const float> near_m, const Pose2& T_map_laser,
               double reach_m, Viewpoint viewpoint)
      : floor_(floor),
        laser_(laser),
        ranges_m_(ranges_m),
        free_to_m_(free_to_m),
        near_m_(near_m),
        T_map_laser_(T_map_laser),
        reach_m_(reach_m),
        viewpoint_(viewpoint),
        around_(box_of_beams()),
        hit_(static_cast<std::size_t>(around_.end.x - around_.low.x) *
                 static_cast<std::size_t>(around_.end.y - around_.low.y),
             false) {}

  FloorBox paint() {
    for (std::size_t beam = 0; beam < ranges_m_.size(); ++beam) strike(beam);
    for (int y = around_.low.y; y < around_.end.y; ++y) {
      for (int x = around_.low.x; x < around_.end.x; ++x) pass({x, y});
    }
    return changed_;
  }

 private:
  /// Contains every cell that the beams pass or hit.
  FloorBox box_of_beams() const {
    FloorBox box;
    box.include(floor_.cell_at(T_map_laser_.position()));
    for (std::size_t beam = 0; beam < ranges_m_.size(); ++beam) {
      if (!is_usable(beam)) continue;
      const double range_m = std::min<double>(ranges_m_[beam], reach_m_);
      box.include(floor_.cell_at(Vec2(T_map_laser_ * Vec2(range_m * unit(laser_.beam_angle(beam))))));
    }
    return box.widened(1);
  }

  bool is_usable(std::size_t beam) const { return std::isfinite(ranges_m_[beam]) && ranges_m_[beam] > 0; }

  void strike(std::size_t beam) {
    const double range_m = ranges_m_[beam];
    if (!is_usable(beam) || range_m >= laser_.range_max_m || range_m > reach_m_) return;
    const Vec2 p_map = T_map_laser_ * Vec2(range_m * unit(laser_.beam_angle(beam)));
    const FloorCell cell = floor_.cell_at(p_map);
    if (!around_.contains(cell) || hit_[place(cell)]) return;
    hit_[place(cell)] = true;
    if (is_solid(beam) ? floor_.see_solid(cell) : floor_.see_occupied(cell)) changed_.include(cell);
  }

  /// A beam beside it hits about there, too.
  bool is_solid(std::size_t beam) const {
    const auto hits_there = [&](std::size_t beside) {
      return beside < ranges_m_.size() && is_usable(beside) &&
             std::abs(ranges_m_[beside] - ranges_m_[beam]) < kSolid_m;
    };
    return hits_there(beam - 1) || hits_there(beam + 1);
  }

  /// A cell nearer than the hits of the beams on both sides of it is free.
  void pass(FloorCell cell) {
    if (hit_[place(cell)]) return;
    const Vec2 towards = floor_.centre(cell) - T_map_laser_.position();
    const double distance_m = towards.norm();
    if (distance_m > reach_m_) return;
    const double from_first_rad =
        wrap_angle(heading_of(towards) - T_map_laser_.theta - laser_.first_angle_rad - kPi) + kPi;
    const double beam = from_first_rad / laser_.angle_step_rad;
    const double below = std::floor(beam);
    if (below < 0 || below + 1 >= static_cast<double>(ranges_m_.size())) return;
    const auto first = static_cast<std::size_t>(below);
    if (!is_usable(first) || !is_usable(first + 1)) return;
    const double far_m = std::min(free_to_m_[first], free_to_m_[first + 1]) - floor_.cell_m();
    const double near_m = near_m_.empty() ? 0 : std::max(near_m_[first], near_m_[first + 1]);
    if (distance_m >= far_m || distance_m < near_m) return;
    if (pass_beside(cell, distance_m * laser_.angle_step_rad, is_partly_hidden(cell, distance_m, beam)))
      changed_.include(cell);
  }

  /// Beams `apart_m` apart pass the cell, with nothing hit in it. @return whether its state has changed
  bool pass_beside(FloorCell cell, double apart_m, bool is_partly_hidden) {
    if (is_partly_hidden) return floor_.seem_free(cell);
    if (apart_m <= kThin_m) return floor_.see_free(cell);
    const bool is_new_look = viewpoint_ == Viewpoint::kMoved || floor_.is_dynamic(cell);
    const bool would_be_hit = is_new_look && apart_m <= kOftenHit_m;
    return would_be_hit ? floor_.fade(cell) : floor_.seem_free(cell);
  }

  /// Whether something in front hides one side of an occupied cell, as a door's jamb hides its own face: the
  /// hit may be on that side. O(beams across the cell); only occupied cells are examined like this.
  bool is_partly_hidden(FloorCell cell, double distance_m, double beam) const {
    if (floor_.at(cell) != Floor::kOccupied) return false;
    const double half_beams = floor_.cell_m() / 2 / distance_m / laser_.angle_step_rad;
    const auto first = static_cast<std::size_t>(std::ceil(std::max(beam - half_beams, 0.0)));
    const auto last =
        static_cast<std::size_t>(std::min(beam + half_beams, static_cast<double>(ranges_m_.size() - 1)));
    for (std::size_t across = first; across <= last; ++across) {
      if (is_usable(across) && ranges_m_[across] < distance_m - floor_.cell_m()) return true;
    }
    return false;
  }

  std::size_t place(FloorCell cell) const {
    return static_cast<std::size_t>(cell.y - around_.low.y) *
               static_cast<std::size_t>(around_.end.x - around_.low.x) +
           static_cast<std::size_t>(cell.x - around_.low.x);
  }

  FloorGrid& floor_;
  const LaserScanner& laser_;
  std::span<const float> ranges_m_;
  std::span<const float> free_to_m_;
  std::span<const float> near_m_;
  Pose2 T_map_laser_;
  double reach_m_;
  Viewpoint viewpoint_;
  FloorBox around_;
  std::vector<bool> hit_;
  FloorBox changed_;
};

/// The cell is occupied; or it is unknown and may be, next to an occupied one: part of a wall that was not
/// seen.
bool may_stand_at(const FloorGrid& floor, FloorCell cell) {
  if (floor.at(cell) != Floor::kUnknown) return floor.at(cell) == Floor::kOccupied;
  return is_occupied_near(floor, cell, static_cast<int>(kWallGap_m / floor.cell_m()));
}

/// Whether something known stands before the range at which the beam begins to look, or slightly behind it:
/// cells are coarse.
bool is_shut(const FloorGrid& floor, const Pose2& T_map_laser, double angle_rad, double near_m) {
  const Vec2 along = unit(T_map_laser.theta + angle_rad);
  const double step_m = floor.cell_m() / 2;
  const int steps = static_cast<int>(std::ceil((near_m + kCoarse * floor.cell_m()) / step_m));
  for (int step = 0; step < steps; ++step) {
    if (may_stand_at(floor, floor.cell_at(T_map_laser.position() + step * step_m * along))) return true;
  }
  return false;
}

/// Drops beams without a return between two hits that leave no opening to drive through: black or shiny
/// surfaces absorbed them.
void leave_out_lost(const LaserScanner& laser, std::vector<float>& usable_m) {
  const auto hit_at = [&](std::size_t beam) { return Vec2(usable_m[beam] * unit(laser.beam_angle(beam))); };
  std::optional<std::size_t> hit;
  for (std::size_t beam = 0; beam < usable_m.size(); ++beam) {
    const bool is_hit = usable_m[beam] > 0 && usable_m[beam] < laser.range_max_m;
    if (!is_hit) continue;
    if (hit && beam > *hit + 1) {
      const double across_m = (hit_at(*hit) - hit_at(beam)).norm();
      if (across_m < kLostAcross_m)
        std::fill(usable_m.begin() + static_cast<std::ptrdiff_t>(*hit + 1),
                  usable_m.begin() + static_cast<std::ptrdiff_t>(beam), 0.0F);
    }
    hit = beam;
  }
}

/// The ranges that can be used; 0: none. A beam without a return shows free floor only where nothing is known
/// to stand nearer than it looks.
std::vector<float> usable_ranges_m(const FloorGrid& floor, const LaserScanner& laser,
                                   std::span<const float> ranges_m, std::span<const float> near_m,
                                   const Pose2& T_map_laser) {
  std::vector<float> usable_m(ranges_m.begin(), ranges_m.end());
  for (std::size_t beam = 0; beam < near_m.size(); ++beam) {
    if (usable_m[beam] >= laser.range_max_m &&
        is_shut(floor, T_map_laser, laser.beam_angle(beam), near_m[beam]))
      usable_m[beam] = 0;
  }
  const bool marks_lost_beams = !near_m.empty();
  if (!marks_lost_beams) leave_out_lost(laser, usable_m);
  return usable_m;
}

/// Distance along a beam to the first cell that is known to be occupied; `reach_m` if there is none within
/// it.
double occupied_at_m(const FloorGrid& floor, const Pose2& T_map_laser, double angle_rad, double reach_m) {
  const Vec2 along = unit(T_map_laser.theta + angle_rad);
  const double step_m = floor.cell_m() / 2;
  const int steps = static_cast<int>(reach_m / step_m);
  for (int step = 0; step < steps; ++step) {
    const FloorCell cell = floor.cell_at(T_map_laser.position() + step * step_m * along);
    if (floor.at(cell) == Floor::kOccupied) return step * step_m;
  }
  return reach_m;
}

/// How far each beam shows free floor. One without a return does so only up to what is known to stand there:
/// something absorbed it, or it went through glass.
std::vector<float> free_ranges_m(const FloorGrid& floor, const LaserScanner& laser,
                                 std::span<const float> ranges_m, const Pose2& T_map_laser, double reach_m) {
  std::vector<float> free_m(ranges_m.begin(), ranges_m.end());
  for (std::size_t beam = 0; beam < free_m.size(); ++beam) {
    if (free_m[beam] < laser.range_max_m) continue;
    const double occupied_m = occupied_at_m(floor, T_map_laser, laser.beam_angle(beam), reach_m);
    if (occupied_m < reach_m) free_m[beam] = static_cast<float>(occupied_m);
  }
  return free_m;
}

}  // namespace

void FloorViewParams::describe(FieldList& fields) {
  fields.real("reach_m", reach_m, {1, 20}, "farther floor is left unknown");
}

FloorBox see_floor(FloorGrid& floor, const LaserScanner& laser, std::span<const float> ranges_m,
                   std::span<const float> near_m, const Pose2& T_map_vehicle, const FloorViewParams& params,
                   Viewpoint viewpoint) {
  const Pose2 T_map_laser = T_map_vehicle * laser.T_vehicle_laser;
  const std::vector<float> usable_m = usable_ranges_m(floor, laser, ranges_m, near_m, T_map_laser);
  const std::vector<float> free_m = free_ranges_m(floor, laser, usable_m, T_map_laser, params.reach_m);
  return FloorPainter(floor, laser, usable_m, free_m, near_m, T_map_laser, params.reach_m, viewpoint).paint();
}

FloorBox stand_on_floor(FloorGrid& floor, const Footprint& footprint, const Pose2& T_map_vehicle) {
  const double half_m = footprint.width_m / 2;
  const double touched_m = floor.cell_m() * std::numbers::sqrt2 / 2;
  const double reach_m = std::hypot(std::max(footprint.front_m, footprint.rear_m), half_m) + touched_m;
  const FloorBox around = box_around(floor, T_map_vehicle.position(), reach_m);
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  FloorBox changed;
  for (int y = around.low.y; y < around.end.y; ++y) {
    for (int x = around.low.x; x < around.end.x; ++x) {
      const Vec2 p_vehicle = T_vehicle_map * floor.centre({x, y});
      const double outside_m = std::max({p_vehicle.x() - footprint.front_m, -footprint.rear_m - p_vehicle.x(),
                                         std::abs(p_vehicle.y()) - half_m});
      const bool covers =
          outside_m <= 0 || (outside_m <= touched_m && floor.at(FloorCell{x, y}) == Floor::kUnknown);
      const bool surely = outside_m <= -kSurelyInside_m;
      if (surely ? floor.stand_on({x, y}) : covers && floor.see_free({x, y})) changed.include({x, y});
    }
  }
  return changed;
}

FloorBox strike_floor(FloorGrid& floor, const Footprint& footprint, const Pose2& T_map_vehicle, Gear gear) {
  const double half_m = footprint.width_m / 2;
  const double end_m = gear == Gear::kReverse ? footprint.rear_m : footprint.front_m;
  const double from_m = kHitFrom * floor.cell_m(), to_m = kHitTo * floor.cell_m();
  const FloorBox around =
      box_around(floor, T_map_vehicle.position(), std::hypot(end_m + to_m, half_m) + floor.cell_m());
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  FloorBox changed;
  for (int y = around.low.y; y < around.end.y; ++y) {
    for (int x = around.low.x; x < around.end.x; ++x) {
      const Vec2 p_vehicle = T_vehicle_map * floor.centre({x, y});
      const double beyond_m = sign(gear) * p_vehicle.x() - end_m;
      if (beyond_m < from_m || beyond_m > to_m || std::abs(p_vehicle.y()) > half_m) continue;
      if (floor.at(FloorCell{x, y}) != Floor::kOccupied) changed.include({x, y});
      floor.set({x, y}, Floor::kOccupied);
    }
  }
  return changed;
}

}  // namespace aisle
