#include <algorithm>
#include <cmath>
#include <map>

#include "rendering/scene_plan.hpp"

namespace aisle {
namespace {

/// Where a door with its frame covers a wall, in the frame of the closed leaf.
struct Doorway {
  Pose2 T_leaf_world;
  double begin_m = 0, end_m = 0;  ///< along the leaf
  double half_depth_m = 0;        ///< across it
};

Doorway doorway_of(const Door& door) {
  constexpr double kOnTheWall_m = 0.1;
  const Pose2 T_world_leaf{door.hinge.x(), door.hinge.y(), door.closed_heading_rad};
  return {T_world_leaf.inverse(), -door.frame_width_m, door.width_m + door.frame_width_m,
          door.wall_depth_m / 2 + kOnTheWall_m};
}

/// The part of a wall's line that lies in the doorway, as shares of its length.
Interval inside(const Segment2& wall_line, const Doorway& doorway) {
  const Vec2 start = doorway.T_leaf_world * wall_line.start, end = doorway.T_leaf_world * wall_line.end;
  Interval shares{0, 1};
  const auto clip = [&](double at_start, double at_end, double min, double max) {
    const double growth = at_end - at_start;
    if (std::abs(growth) < 1e-9) {
      if (at_start < min || at_start > max) shares = {1, 0};
      return;
    }
    const double a = (min - at_start) / growth, b = (max - at_start) / growth;
    shares.min = std::max(shares.min, std::min(a, b));
    shares.max = std::min(shares.max, std::max(a, b));
  };
  clip(start.x(), end.x(), doorway.begin_m, doorway.end_m);
  clip(start.y(), end.y(), -doorway.half_depth_m, doorway.half_depth_m);
  return shares;
}

/// The parts of a wall's line outside all doorways.
std::vector<Segment2> outside_doorways(const Segment2& wall_line, const std::vector<Doorway>& doorways) {
  std::vector<Interval> cuts;
  for (const Doorway& doorway : doorways) {
    const Interval cut = inside(wall_line, doorway);
    if (cut.min < cut.max) cuts.push_back(cut);
  }
  std::sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.min < b.min; });
  std::vector<Segment2> left;
  const auto add = [&](double from, double to) {
    const Vec2 along = wall_line.end - wall_line.start;
    if ((to - from) * along.norm() > 1e-3)
      left.push_back({wall_line.start + from * along, wall_line.start + to * along});
  };
  double from = 0;
  for (const Interval& cut : cuts) {
    add(from, cut.min);
    from = std::max(from, cut.max);
  }
  add(from, 1);
  return left;
}

/// A board on both sides of a wall; a little longer than the wall, so that boards meet in corners.
Prism skirting_board(const Segment2& wall_line, double height_m) {
  const Vec2 along = wall_line.end - wall_line.start, middle = (wall_line.start + wall_line.end) / 2;
  return box({middle.x(), middle.y(), heading_of(along)},
             {along.norm() + 2 * kSkirtingDepth_m, 2 * kSkirtingDepth_m}, 0, height_m);
}

/// One material for all walls of a brightness.
class WallMaterials {
 public:
  explicit WallMaterials(Materials& materials) : materials_(materials) {}
  int operator[](double brightness) {
    const auto [entry, is_new] = known_.try_emplace(brightness, 0);
    if (is_new) entry->second = materials_.plaster(brightness);
    return entry->second;
  }

 private:
  Materials& materials_;
  std::map<double, int> known_;
};

}  // namespace

Extent extent_of(const World& world) {
  constexpr double kAround_m = 3;
  Extent extent{Vec2::Constant(1e30), Vec2::Constant(-1e30)};
  const auto take = [&](const Vec2& p) {
    extent.min = extent.min.cwiseMin(p);
    extent.max = extent.max.cwiseMax(p);
  };
  for (const WallFace& wall : world.walls) {
    take(wall.floor_edge.start);
    take(wall.floor_edge.end);
  }
  for (const Furniture& piece : world.furniture) take(piece.centre);
  for (const Door& door : world.doors) take(door.hinge);
  for (const CalibrationBoard& board : world.boards) take(board.p_world_centre.head<2>());
  for (const FloorPaper& paper : world.papers) take(paper.centre);
  if (extent.min.x() > extent.max.x()) take(Vec2::Zero());
  return {extent.min - Vec2::Constant(kAround_m), extent.max + Vec2::Constant(kAround_m)};
}

void add_rooms(const World& world, Materials& materials, Panels& panels) {
  const Extent extent = extent_of(world);
  const Vec2 size = extent.size();
  panels.push_back({.corner = {extent.max.x(), extent.min.y(), 0},
                    .along = {-size.x(), 0, 0},
                    .up = {0, size.y(), 0},
                    .material = materials.floor(world.floor)});
  panels.push_back({.corner = {extent.min.x(), extent.min.y(), world.ceiling_m},
                    .along = {size.x(), 0, 0},
                    .up = {0, size.y(), 0},
                    .material = materials.ceiling(world.ceiling_brightness)});

  WallMaterials wall_materials(materials);
  std::vector<Doorway> doorways;
  for (const Door& door : world.doors) doorways.push_back(doorway_of(door));
  const int skirting = materials.paint(world.skirting_brightness);
  for (const WallFace& wall : world.walls) {
    if (wall.is_glass()) continue;
    const Vec2 along = wall.floor_edge.end - wall.floor_edge.start;
    panels.push_back({.corner = {wall.floor_edge.start.x(), wall.floor_edge.start.y(), 0},
                      .along = {along.x(), along.y(), 0},
                      .up = {0, 0, wall.height_m},
                      .material = wall_materials[wall.brightness],
                      .is_two_sided = true});
    const double board_m = std::min(world.skirting_height_m, wall.height_m);
    if (board_m <= 0) continue;
    for (const Segment2& wall_line : outside_doorways(wall.floor_edge, doorways)) {
      add_prism(skirting_board(wall_line, board_m), skirting, panels);
    }
  }
}

}  // namespace aisle
