#include "aisle/learning/walls_beside.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kAlong_rad = 8 * kDegree;
constexpr double kSeenBesideMin_m = 0.2;

}  // namespace

void find_walls_beside(std::span<const SensedSegment> edges, const Pose2& T_way_vehicle,
                       std::vector<WallBeside>& beside) {
  beside.clear();
  for (const SensedSegment& edge : edges) {
    if (edge.length_m < kSeenBesideMin_m) continue;
    const Vec2 start = T_way_vehicle * edge.segment.start, end = T_way_vehicle * edge.segment.end;
    const double along_m = std::abs(end.x() - start.x()), across_m = std::abs(end.y() - start.y());
    if (std::atan2(across_m, along_m) > kAlong_rad) continue;
    beside.push_back({.aside_m = (T_way_vehicle * edge.centroid).y(),
                      .length_m = edge.length_m,
                      .from_m = std::min(start.x(), end.x()),
                      .to_m = std::max(start.x(), end.x()),
                      .sigma_m = edge.sigma_offset_m,
                      .p_vehicle = edge.centroid});
  }
}

}  // namespace aisle
