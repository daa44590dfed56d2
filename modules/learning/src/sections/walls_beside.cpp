#include "aisle/learning/sections/walls_beside.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kParallelWithin_rad = 8 * kDegree;
constexpr double kSeenWallMin_m = 0.2;

}  // namespace

void find_walls_beside(std::span<const SensedSegment> edges, const Pose2& T_path_vehicle,
                       std::vector<WallBeside>& beside) {
  beside.clear();
  for (const SensedSegment& edge : edges) {
    if (edge.length_m < kSeenWallMin_m) continue;
    const Vec2 start = T_path_vehicle * edge.segment.start, end = T_path_vehicle * edge.segment.end;
    const double along_m = std::abs(end.x() - start.x()), across_m = std::abs(end.y() - start.y());
    if (std::atan2(across_m, along_m) > kParallelWithin_rad) continue;
    beside.push_back({.lateral_m = (T_path_vehicle * edge.centroid).y(),
                      .length_m = edge.length_m,
                      .from_m = std::min(start.x(), end.x()),
                      .to_m = std::max(start.x(), end.x()),
                      .sigma_m = edge.sigma_offset_m,
                      .p_vehicle = edge.centroid});
  }
}

void find_walls_across(std::span<const SensedSegment> edges, const Pose2& T_path_vehicle,
                       std::vector<WallAcross>& across) {
  across.clear();
  for (const SensedSegment& edge : edges) {
    if (edge.length_m < kSeenWallMin_m) continue;
    const Vec2 start = T_path_vehicle * edge.segment.start, end = T_path_vehicle * edge.segment.end;
    const double along_m = std::abs(end.x() - start.x()), across_m = std::abs(end.y() - start.y());
    if (std::atan2(along_m, across_m) > kParallelWithin_rad) continue;
    const double ahead_m = std::abs(cross(unit(edge.heading_rad), edge.centroid));
    const double side = edge.centroid.x() < 0 ? -1 : 1;
    across.push_back({.along_m = T_path_vehicle.x + side * ahead_m,
                      .from_m = std::min(start.y(), end.y()),
                      .to_m = std::max(start.y(), end.y()),
                      .sigma_m = edge.sigma_offset_m});
  }
}

}  // namespace aisle
