#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/connection/connection_counts.hpp"
#include "aisle/connection/seen_camera.hpp"
#include "aisle/connection/topic_pace.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// What a robot says, judged before it is driven.
struct RobotCheck {
  VehicleDescription vehicle;   ///< as it would be driven
  std::size_t beams = 0;        ///< 0: no scanner
  bool is_upside_down = false;  ///< the scanner
  std::string command_type;     ///< empty: the connection has no topic of commands
  TopicPace scan;
  TopicPace odometry;
  std::vector<SeenCamera> cameras;  ///< as in the connection
  ConnectionCounts counts;
  double standing_m = 0;  ///< how far the odometry says that the robot moved meanwhile
  Problems warnings;
};

/// Listens to a robot for a while. Nothing is commanded.
/// @return problems if the robot cannot be driven over the connection
Result<RobotCheck> check_robot(const Connection& connection, const VehicleDescription& vehicle,
                               const ConnectedVehicle::Surroundings& surroundings, double listen_s);

}  // namespace aisle
