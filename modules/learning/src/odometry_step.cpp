#include "aisle/learning/odometry_step.hpp"

#include "odometry_arc.hpp"

namespace aisle {

Pose2 odometry_step(const VehicleDescription& vehicle, const OdometryReading& reading) {
  return end_pose(uncertain_arc(vehicle, reading).arc);
}

}  // namespace aisle
