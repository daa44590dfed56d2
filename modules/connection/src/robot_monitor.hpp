#pragma once

#include <string>
#include <vector>

#include "aisle/core/clock.hpp"
#include "robot_intake.hpp"

namespace aisle {

/// Judges by what a robot has said so far whether it may be driven on.
class RobotMonitor {
 public:
  /// Takes the intake's lock; all must outlive it. @param vehicle  as it is driven
  RobotMonitor(const Connection& connection, const VehicleDescription& vehicle, RobotIntake& intake,
               const Clock& clock);

  // These need the intake's lock.
  std::string why_end() const;   ///< empty: the mission goes on
  std::string why_held() const;  ///< empty: the vehicle may move
  void add_ages(ConnectionCounts& counts) const;

 private:
  /// A sensor that the mission drives by.
  struct Sensor {
    std::string name, type;
    const StreamState& stream;
    double period_s;
    double silent_max_s;
  };

  double silent_s(double arrived_s) const;
  std::string silence(const std::string& name, const std::string& type, double for_s) const;
  std::string why_late() const;

  const Connection& connection_;
  RobotIntake& intake_;
  const Clock& clock_;
  double connected_s_;
  std::vector<Sensor> sensors_;
};

}  // namespace aisle
