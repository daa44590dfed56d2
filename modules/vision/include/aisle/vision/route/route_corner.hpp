#pragma once

#include <optional>
#include <span>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct RouteCornerParams {
  double side_min_m = 0.12;
  double gap_m = 0.2;
  double beyond_m = 0.4;
  double turn_rad = 15 * kDegree;
  double reach_m = 3;

  void describe(FieldList& fields);
};

enum class RouteSide { kLeft, kRight };

/// The corner where a route turns off to a side, as a camera that looks along the route sees it. The floor
/// edge of what stands beside the route ends there, and the next thing in view is farther away and off the
/// line of that edge (L96 section 3.3; how the corner is found is not published).
/// @param p_vehicle_edges  where the route ends, in the order of the view's columns from the left
///                         (RouteSight); what stands there is seen down to the floor
/// @param p_vehicle_camera  the floor point beneath the camera
/// @return nullopt: nothing stands on that side, or it goes on to the other end of the view
std::optional<Vec2> find_route_corner(std::span<const Vec2> p_vehicle_edges, const Vec2& p_vehicle_camera,
                                      RouteSide side, const RouteCornerParams& params);

}  // namespace aisle
