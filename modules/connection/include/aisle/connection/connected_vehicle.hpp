#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "aisle/connection/connection_counts.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/vehicle.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// A robot that speaks ROS 2, as a vehicle; see docs/explanation/connection.md. It is stopped when nothing
/// newer is known: however a mission ends, the robot is told to stand still.
class ConnectedVehicle final : public Vehicle {
 public:
  /// What the vehicle needs of its surroundings; all must outlive it.
  struct Surroundings {
    Wire& wire;
    const Clock& clock;
    Progress& progress;  ///< asked several times a second while the vehicle waits; may throw Interrupted
    std::function<void(const std::string&)> note;  ///< "held: the emergency stop is pressed"; never empty
  };

  /// Waits up to 10 s for scans, images, odometry, the sensors' mounts, the cameras' lenses and somebody who
  /// reads the commands. What the connection leaves empty is not there: without a topic of scans there is no
  /// scanner, without one of commands nothing is sent, without one of a joystick nobody drives by one.
  /// @param vehicle  from the vehicle file; its scanner and cameras are replaced by the connection's, unless
  ///                 the mounts are of the file; its limits by those of the connection
  /// @return problems, each with what there is instead. Nothing has been commanded then
  static Result<std::unique_ptr<ConnectedVehicle>> connect(const Connection& connection,
                                                           const VehicleDescription& vehicle,
                                                           Surroundings surroundings);
  ~ConnectedVehicle() override;
  ConnectedVehicle(const ConnectedVehicle&) = delete;
  ConnectedVehicle& operator=(const ConnectedVehicle&) = delete;

  /// Sensors, limits and cycle are those of the robot.
  const VehicleDescription& description() const override;

  /// One observation per scan, stamped with the scan's end; without a scanner, per image of the first camera.
  /// It has the newest image of each camera that is not from after it. The first is one cycle after 0. While
  /// the vehicle is held (an emergency stop, no odometry, somebody else who sends commands), this waits and
  /// its clock stands still.
  /// @throws Interrupted  from the progress
  std::optional<Observation> sense() override;
  std::string end_reason() const override;
  void act(const Command& command) override;

  /// Sends nothing at all, not even stops, until it is told otherwise: to see whether the robot stops by
  /// itself.
  void fall_silent(bool is_silent);

  /// Where the vehicle was at the latest observation, by the robot's own clock and odometry.
  struct Odometry {
    ros::Stamp_ns stamp = 0;
    Pose2 T_odom_vehicle;
  };
  const Odometry& odometry() const;

  /// What the robot last said of its battery.
  struct Battery {
    double charge = 0;  ///< 0 to 1
    double age_s = 0;   ///< since that arrived
  };
  /// nullopt: nothing, or its topic is not in the connection.
  std::optional<Battery> battery() const;

  /// What was commanded so far, by the times at which commands were sent.
  Arc commanded() const;

  ConnectionCounts counts() const;

 private:
  class Cycle;
  explicit ConnectedVehicle(std::unique_ptr<Cycle> cycle);

  std::unique_ptr<Cycle> cycle_;
};

}  // namespace aisle
