#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "aisle/core/clock.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/wire/wire.hpp"
#include "joint_odometry.hpp"
#include "robot_state.hpp"

namespace aisle {

/// A topic that a connection needs, and what it must be.
struct NeededTopic {
  std::string topic;
  std::string type;
};

/// Takes what a robot says off the wire and puts it into aisle's terms.
class RobotIntake {
 public:
  /// `clock` must outlive the intake.
  static Result<std::unique_ptr<RobotIntake>> open(Wire& wire, const Connection& connection,
                                                   const VehicleDescription& vehicle, const Clock& clock);

  RobotIntake(const Connection& connection, const VehicleDescription& vehicle, const Clock& clock);
  RobotIntake(const RobotIntake&) = delete;
  RobotIntake& operator=(const RobotIntake&) = delete;

  /// The topics without which nothing can be driven: scans and odometry.
  std::vector<NeededTopic> needed_topics() const;
  const WireSubscription& scans() const { return *subscriptions_[0]; }
  const WireSubscription& odometry() const { return *subscriptions_[1]; }

  /// Guards the state; the waits release it meanwhile.
  std::unique_lock<std::mutex> lock() { return std::unique_lock(mutex_); }
  /// Until something has arrived since the last such wait.
  void wait(std::unique_lock<std::mutex>& lock, double most_s);
  /// Until the odometry is as new as a stamp.
  void wait_for_odometry(std::unique_lock<std::mutex>& lock, double stamp_s, double most_s);
  RobotState& state() { return state_; }

  /// The time that ages count by: aisle's own, or /clock (0 until it is known). Needs the lock.
  double now_s() const;
  /// The time by which a robot judges stamps: its newest one, carried on; the machines' common clock where
  /// its own make no sense. Needs the lock, and odometry that has arrived.
  double robot_time_s() const;

 private:
  Problems subscribe(Wire& wire);
  template <class Message>
  Problems subscribe(Wire& wire, const std::string& topic, WireQuality quality,
                     bool (RobotIntake::*take)(const Message&));
  Problems subscribe_odometry(Wire& wire);
  Problems subscribe_switches(Wire& wire, const std::vector<ConnectedSwitch>& switches,
                              std::vector<SwitchState>& states);

  /// Parses a message and gives it to `take`, under the lock; counts what cannot be read or makes no sense.
  template <class Message, class Take>
  void arrive(std::string_view bytes, const Take& take);

  // @return whether the message makes sense
  bool take_scan(const ros::LaserScan& message);
  bool take_odometry(const ros::Odometry& message);
  bool take_odometry_transforms(const ros::TFMessage& message);
  bool take_wheels(const ros::JointState& message);
  bool take_fixed_transforms(const ros::TFMessage& message);
  bool take_battery(const ros::BatteryState& message);
  bool take_clock(const ros::Clock& message);
  bool take_pose(double stamp_s, const ros::Vector3& position, const ros::Quaternion& orientation);
  bool take_base(double stamp_s, const Pose2& T_odom_base);

  ros::Stamp_ns stamp_of(const ros::Header& header) const;
  double age_s(double stamp_s) const;
  void note_jump(std::string what);
  void be_broken(std::string why);

  const Connection connection_;
  const Clock& clock_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  bool has_news_ = false;  ///< since the last wait()
  RobotState state_;
  JointOdometry wheels_;
  std::vector<std::unique_ptr<WireSubscription>> subscriptions_;  ///< last: they end before what they fill
};

}  // namespace aisle
