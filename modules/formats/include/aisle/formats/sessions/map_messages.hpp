#pragma once
/// The navigator's map and plan as messages for viewers, in the frame "map". Sessions do not contain them.

#include <string>

#include "aisle/control/path.hpp"
#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// /pose, geometry_msgs/PoseWithCovarianceStamped
const SessionTopic& pose_topic();
std::string pose_cdr(ros::Stamp_ns stamp, const UncertainPose2& T_map_vehicle);

/// /plan, nav_msgs/Path: one pose per 0.1 m of path.
const SessionTopic& plan_topic();
std::string plan_cdr(ros::Stamp_ns stamp, const Path& path);

/// /map, visualization_msgs/MarkerArray, latched: walls, landmarks, the graph of corridors, routes, places,
/// keep-out lines and glass, each in its own namespace.
const SessionTopic& map_topic();
std::string map_cdr(ros::Stamp_ns stamp, const Building& building);

/// /floor, std_msgs/String, latched: the part "floor" of a building file.
const SessionTopic& floor_topic();
std::string floor_cdr(const FloorGrid& floor);

/// /grid, nav_msgs/OccupancyGrid, latched: the same floor, as ROS has it.
const SessionTopic& grid_topic();
std::string grid_cdr(ros::Stamp_ns stamp, const FloorGrid& floor);

}  // namespace aisle
