#include "aisle/report/occupancy.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kCell_m = 0.05;
constexpr double kMargin_m = 1;
constexpr double kSweptEvery_m = 0.5;  // scans nearer than this to the last one used add little
constexpr double kSweptEvery_rad = 0.5;
constexpr double kSweptReach_m = 12;
constexpr double kShortOfWall_m = 0.1;  // a beam is free only up to this distance before its hit

struct Box {
  Vec2 low = Vec2::Constant(1e9);
  Vec2 high = Vec2::Constant(-1e9);

  void include(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

Box box_of(const WallMap& walls, std::span<const Pose2> T_map_vehicle) {
  Box box;
  for (const Pose2& pose : T_map_vehicle) box.include(pose.position());
  for (const Wall& wall : walls.walls) {
    box.include(wall.segment.start);
    box.include(wall.segment.end);
  }
  return {box.low.array() - kMargin_m, box.high.array() + kMargin_m};
}

class CellCanvas {
 public:
  CellCanvas(const Box& box, double cells_max) {
    const Vec2 size_m = box.high - box.low;
    image_.resolution_m = std::max(kCell_m, std::sqrt(size_m.x() * size_m.y() / cells_max));
    image_.width = static_cast<int>(std::ceil(size_m.x() / image_.resolution_m));
    image_.height = static_cast<int>(std::ceil(size_m.y() / image_.resolution_m));
    image_.origin_m = box.low;
    image_.cells.assign(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height),
                        kCellUnknown);
  }

  /// Sets every cell that the segment crosses; cells outside the grid are skipped.
  void draw(const Vec2& from, const Vec2& to, std::uint8_t value) {
    const Vec2 a = (from - image_.origin_m) / image_.resolution_m,
               b = (to - image_.origin_m) / image_.resolution_m;
    const Vec2 offset = b - a;
    const auto steps = static_cast<int>(std::ceil(std::max(std::abs(offset.x()), std::abs(offset.y())))) + 1;
    const Vec2 step = offset / steps;
    Vec2 at = a;
    for (int i = 0; i <= steps; ++i, at += step) {
      const auto column = static_cast<int>(at.x()), row = image_.height - 1 - static_cast<int>(at.y());
      if (column < 0 || row < 0 || column >= image_.width || row >= image_.height) continue;
      image_.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                   static_cast<std::size_t>(column)] = value;
    }
  }

  OccupancyImage take() { return std::move(image_); }

 private:
  OccupancyImage image_;
};

void draw_occupied(const FloorGrid& floor, CellCanvas& canvas) {
  const FloorBox& known = floor.known();
  for (int y = known.low.y; y < known.end.y; ++y) {
    for (int x = known.low.x; x < known.end.x; ++x) {
      const Vec2 p_map = floor.centre({x, y});
      if (floor.at(FloorCell{x, y}) == Floor::kOccupied) canvas.draw(p_map, p_map, kCellOccupied);
    }
  }
}

}  // namespace

OccupancyImage occupancy_of(const WallMap& walls, const FloorGrid& floor, const LaserLog& log,
                            std::span<const Pose2> T_map_vehicle, double cells_max) {
  CellCanvas canvas(box_of(walls, T_map_vehicle), cells_max);
  const Pose2* swept = nullptr;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    if (swept) {
      const Pose2 moved = between(*swept, T_map_vehicle[i]);
      if (std::hypot(moved.x, moved.y) < kSweptEvery_m && std::abs(moved.theta) < kSweptEvery_rad) continue;
    }
    swept = &T_map_vehicle[i];
    const LaserScanner laser = log.laser_of(log.scans[i]);
    const Pose2 T_map_laser = T_map_vehicle[i] * laser.T_vehicle_laser;
    const std::vector<float>& ranges_m = log.scans[i].ranges_m;
    for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
      const double range_m = ranges_m[beam];
      if (range_m <= kShortOfWall_m || range_m >= laser.range_max_m) continue;
      const double free_m = std::min(range_m - kShortOfWall_m, kSweptReach_m);
      const Vec2 along = unit(T_map_laser.theta + laser.beam_angle(beam));
      canvas.draw(T_map_laser.position(), T_map_laser.position() + free_m * along, kCellFree);
    }
  }
  draw_occupied(floor, canvas);
  for (const Wall& wall : walls.walls) canvas.draw(wall.segment.start, wall.segment.end, kCellOccupied);
  return canvas.take();
}

}  // namespace aisle
