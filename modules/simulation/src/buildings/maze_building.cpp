#include "aisle/simulation/buildings/maze_building.hpp"

#include <fmt/format.h>

#include "buildings/rectangle_union.hpp"

namespace aisle {
namespace {

constexpr double side_heading_rad(Side side) {
  switch (side) {
    case Side::kLeft:
      return kPi;
    case Side::kRight:
      return 0;
    case Side::kBottom:
      return -kPi / 2;
    case Side::kTop:
      return kPi / 2;
  }
  return 0;
}

class MazeBuilder {
 public:
  MazeBuilder(const GridWorld& maze, const MazeBuildingParams& params)
      : maze_(maze), params_(params), reached_(reachable_cells(maze, maze.start)) {}

  World build() {
    std::vector<Rectangle> floor;
    for (int y = 0; y < maze_.height(); ++y) {
      for (int x = 0; x < maze_.width(); ++x) {
        if (reached_[maze_.index({x, y})]) add_cell({x, y}, floor);
      }
    }
    World world;
    for (const Segment2& wall : walls_around(floor)) world.walls.push_back({.floor_edge = wall});
    world.start = pose_in(maze_.start);
    add_goals(world);
    return world;
  }

 private:
  double pitch_m() const { return params_.corridor_width_m + params_.wall_thickness_m; }
  Vec2 corner(Cell cell) const { return {cell.x * pitch_m(), cell.y * pitch_m()}; }
  bool is_open(Cell cell, Side side) const { return contains(maze_.open(cell), side); }

  /// A cell with its openings to the right and to the top, and the post between them if no wall reaches it.
  void add_cell(Cell cell, std::vector<Rectangle>& floor) const {
    const double width = params_.corridor_width_m;
    const Vec2 lower_left = corner(cell);
    const bool right = is_open(cell, Side::kRight), top = is_open(cell, Side::kTop);
    floor.push_back({lower_left, lower_left + Vec2(width, width)});
    if (right) floor.push_back({lower_left + Vec2(width, 0), lower_left + Vec2(pitch_m(), width)});
    if (top) floor.push_back({lower_left + Vec2(0, width), lower_left + Vec2(width, pitch_m())});
    if (right && top && is_open(neighbour(cell, Side::kRight), Side::kTop) &&
        is_open(neighbour(cell, Side::kTop), Side::kRight)) {
      floor.push_back({lower_left + Vec2(width, width), lower_left + Vec2(pitch_m(), pitch_m())});
    }
  }

  Pose2 pose_in(Cell cell) const {
    const Vec2 centre = corner(cell) + Vec2::Constant(params_.corridor_width_m / 2);
    for (const Side side : {Side::kTop, Side::kRight, Side::kBottom, Side::kLeft}) {
      if (is_open(cell, side)) return {centre.x(), centre.y(), side_heading_rad(side)};
    }
    return {centre.x(), centre.y(), 0};
  }

  void add_goals(World& world) const {
    for (const Cell goal : maze_.goals) {
      if (!reached_[maze_.index(goal)]) continue;
      const std::string name =
          world.places.empty() ? "goal" : fmt::format("goal {}", world.places.size() + 1);
      world.places.push_back({name, pose_in(goal)});
    }
  }

  const GridWorld& maze_;
  MazeBuildingParams params_;
  std::vector<bool> reached_;
};

}  // namespace

World build_maze(const GridWorld& maze, const MazeBuildingParams& params) {
  return MazeBuilder(maze, params).build();
}

}  // namespace aisle
