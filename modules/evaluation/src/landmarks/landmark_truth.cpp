#include "aisle/evaluation/landmarks/landmark_truth.hpp"

#include <algorithm>
#include <limits>

#include "aisle/evaluation/error_figure.hpp"

namespace aisle {
namespace {

constexpr double kReal_m = 0.15;

double distance_m(const Vec2& p_world, std::span<const VerticalEdge> edges) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const VerticalEdge& edge : edges) nearest_m = std::min(nearest_m, (edge.p_world - p_world).norm());
  return nearest_m;
}

}  // namespace

LandmarkTruth compare_with_truth(const LandmarkMap& map, const MapTruth& truth,
                                 std::span<const VerticalEdge> edges) {
  LandmarkTruth found;
  ErrorFigure error_m;
  for (const Landmark& landmark : map.all()) {
    if (landmark.weight <= 0) continue;
    const Pose2 T_map_landmark{landmark.p_map.x(), landmark.p_map.y(), 0};
    const double off_m = distance_m(truth.in_world(T_map_landmark).position(), edges);
    const bool is_real = off_m <= kReal_m, is_sure = landmark.weight >= 1;
    ++found.landmarks;
    if (is_sure) ++found.sure;
    if (!is_real) continue;
    ++found.real;
    if (is_sure) ++found.sure_and_real;
    error_m.add(off_m);
  }
  found.rms_m = error_m.rms();
  return found;
}

}  // namespace aisle
