#pragma once
/// From one drive by hand, with marks, to a route through a room: L96 Algorithm 1.

#include <optional>
#include <span>
#include <vector>

#include "aisle/control/path_fit.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/route.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/route/painted_frame.hpp"

namespace aisle {

/// What one cycle of the drive recorded.
struct RoomCycle {
  double stamp_s = 0;
  OdometryReading odometry;
  std::vector<Mark> marks;
  std::optional<RouteBrightness> patch;  ///< in front of the vehicle, in the first camera's image
  std::vector<Vec2> p_vehicle_painted;   ///< points on painted lines, in the same image
  std::optional<PlaceView> view;         ///< of the same image
  std::vector<Vec2> p_vehicle_edges;     ///< points on the route's edges, in the same image
};

struct RoomLearningParams {
  PathFitParams path{.stray_max_m = 0.05, .radius_min_m = 0.6};
  PaintedFrameParams frame;
  double frame_from_m = 1.2;
  double frame_to_m = 3;
  double views_m = 1;
  double edge_apart_m = 0.05;
  double edge_within_m = 5;
  int edge_sightings = 3;

  void describe(FieldList& fields);
};

struct LearnedRoute {
  Route route;                         ///< starts at the origin, with its room; without a name
  std::vector<Pose2> T_route_vehicle;  ///< of each cycle, by odometry
};

/// Learns a route through a room. The stop mark's label says how to park: frame, dead-end or view. What was
/// driven after it shows a taught place from around it (maps/view_pattern.hpp).
/// @return problems, without a key, if there is no path, no image, a turning that does not end, an unknown
///         label for parking, or no visible frame
Result<LearnedRoute> learn_room_route(std::span<const RoomCycle> cycles, const VehicleDescription& vehicle,
                                      const RoomLearningParams& params);

}  // namespace aisle
