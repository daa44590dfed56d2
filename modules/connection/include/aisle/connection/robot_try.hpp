#pragma once

#include <string>
#include <vector>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/core/result.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A small move, as it was commanded and as it was seen. All are poses of base_link after it, seen from
/// before it.
struct TriedMove {
  std::string name;  ///< "ahead", "left"
  Pose2 commanded;
  Pose2 by_odometry;
  Pose2 by_scans;
};

struct RobotTry {
  std::vector<TriedMove> moves;
  bool stops_by_itself = false;  ///< when commands no longer come
  Problems problems;             ///< swapped axes, wrong signs, wrong scales; empty: the robot may be driven
};

/// Moves a robot by 0.1 m and by 10 degrees, each way and back, and compares what was commanded with what its
/// odometry and its scans say. Then lets commands end while it moves, and watches whether it stops.
/// @return problems if there is no room, or the robot ends the connection
Result<RobotTry> try_robot(ConnectedVehicle& vehicle);

}  // namespace aisle
