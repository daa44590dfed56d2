#include "sections/wall_keeping.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"
#include "aisle/simulation/cross_section.hpp"

namespace aisle {
namespace {

constexpr double kBaseLine_m = 0.02;  // height of the cross section that gives the wall-floor edges
constexpr double kSameLine_m = 0.05;  // greatest distance between walls on one line
constexpr double kOtherObject_m = 0.25;

/// The wall-floor edges without doors: there is no wall at a door.
std::vector<Segment2> base_lines_of(World world) {
  world.doors.clear();
  return cross_section(world, kBaseLine_m);
}

}  // namespace

WallKeeping::WallKeeping(const World& world)
    : base_lines_(base_lines_of(world)), skirting_m_(world.skirting_height_m > 0 ? kSkirtingDepth_m : 0) {}

void WallKeeping::add(std::size_t piece, const Pose2& T_world, double learned_m) {
  const Vec2 right = -left_normal(unit(T_world.theta));
  double nearest_m = std::numeric_limits<double>::infinity(), line_m = 0;
  for (const Segment2& wall : base_lines_) {
    const Vec2 along = wall.end - wall.start, gap = wall.start - T_world.position();
    const double across = cross(right, along);
    if (across == 0) continue;
    const double ray_m = cross(gap, along) / across, share = cross(gap, right) / across;
    if (ray_m < 0 || ray_m >= nearest_m || share < 0 || share > 1) continue;
    nearest_m = ray_m;
    line_m = cross(along, wall.start) / std::copysign(along.norm(), across);
  }
  const double off_m = nearest_m - skirting_m_ - learned_m;
  if (std::abs(off_m) <= kOtherObject_m) of_piece_[piece].push_back({line_m, off_m});
}

ErrorFigure WallKeeping::error_m() const {
  ErrorFigure error_m;
  for (const auto& [piece, seen] : of_piece_) {
    std::vector<double> lines_m;
    for (const Beside& beside : seen) lines_m.push_back(beside.wall_line_m);
    const double usual_m = median(std::move(lines_m));
    for (const Beside& beside : seen)
      if (std::abs(beside.wall_line_m - usual_m) < kSameLine_m) error_m.add(beside.off_m);
  }
  return error_m;
}

}  // namespace aisle
