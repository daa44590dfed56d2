#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "aisle/cameras/live_camera.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/wire/wire.hpp"
#include "joint_odometry.hpp"
#include "robot_state.hpp"

namespace aisle {

/// A topic that a connection needs, and what it must be.
struct NeededTopic {
  std::string topic;
  std::string type;
  const WireSubscription* subscription = nullptr;
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

  // The topics without which nothing can be driven.
  const NeededTopic& scans() const { return scans_; }
  const NeededTopic& odometry() const { return odometry_; }
  /// @param which  of the connection's cameras; one that aisle opens itself has no topic
  const NeededTopic& images(std::size_t which) const { return images_[which]; }

  /// The topic of a camera, or the name of its source.
  std::string camera_name(std::size_t which) const;
  /// What is wrong at present with a camera that aisle opens itself; empty: nothing.
  std::string camera_problem(std::size_t which) const;

  /// Guards the state; the waits release it meanwhile.
  std::unique_lock<std::mutex> lock() { return std::unique_lock(mutex_); }
  /// Until something has arrived since the last such wait.
  void wait(std::unique_lock<std::mutex>& lock, double most_s);
  /// Looks at the cameras that aisle opens itself, as every wait does. Needs the lock.
  void take_live_images();
  /// Until the odometry is as new as a stamp.
  void wait_for_odometry(std::unique_lock<std::mutex>& lock, double stamp_s, double most_s);
  RobotState& state() { return state_; }

  /// An image as pixels; needs no lock.
  Result<std::shared_ptr<const Image>> pixels_of(const ArrivedImage& image, std::size_t which) const;
  /// Counts a message that turned out to be unreadable after it had arrived. Needs the lock.
  void count_unreadable(const std::string& type);

  /// The time that ages count by: aisle's own, or /clock (0 until it is known). Needs the lock.
  double now_s() const;
  /// The time by which a robot judges stamps: its newest one, carried on; the machines' common clock where
  /// its own make no sense. Needs the lock, and odometry that has arrived.
  double robot_time_s() const;

 private:
  Problems subscribe(Wire& wire);
  Problems open_camera(Wire& wire, std::size_t which, const VehicleDescription& vehicle);
  Problems open_live_camera(std::size_t which, const CameraDescription* described);
  /// Keeps a subscription whose messages `take` puts away. @return what `needed` is subscribed as
  Problems subscribe(Wire& wire, NeededTopic& needed, WireQuality quality, Wire::Sink take);
  template <class Message>
  Problems subscribe(Wire& wire, const std::string& topic, WireQuality quality,
                     bool (RobotIntake::*take)(const Message&), NeededTopic* needed = nullptr);
  Problems subscribe_odometry(Wire& wire);
  Problems subscribe_switches(Wire& wire, const std::vector<ConnectedSwitch>& switches,
                              std::vector<SwitchState>& states);

  /// Parses a message and gives it to `take`, under the lock; counts what cannot be read or makes no sense.
  template <class Message, class Take>
  void arrive(std::string_view bytes, const Take& take);
  /// The same for what is not parsed first. @param take  tells whether the message makes sense
  void arrive(const std::string& type, const std::function<bool()>& take);

  // @return whether the message makes sense
  bool take_scan(const ros::LaserScan& message);
  bool take_image(std::string_view message, std::size_t which);
  bool take_joystick(const ros::Joy& message);
  bool take_odometry(const ros::Odometry& message);
  bool take_odometry_transforms(const ros::TFMessage& message);
  bool take_wheels(const ros::JointState& message);
  bool take_fixed_transforms(const ros::TFMessage& message);
  bool take_battery(const ros::BatteryState& message);
  bool take_clock(const ros::Clock& message);
  bool take_pose(double stamp_s, const ros::Vector3& position, const ros::Quaternion& orientation);
  bool take_base(double stamp_s, const Pose2& T_odom_base);

  /// Whether a reading is of the stream's frame and newer than the one before; counts what is not.
  bool is_next(StreamState& stream, const std::string& frame, double stamp_s, const std::string& name);
  void keep_image(ArrivingImages& camera, ArrivedImage image);

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
  std::vector<std::unique_ptr<LiveCamera>> live_cameras_;  ///< as in the connection; null: by a topic
  NeededTopic scans_, odometry_;
  std::vector<NeededTopic> images_;
  std::vector<std::unique_ptr<WireSubscription>> subscriptions_;  ///< last: they end before what they fill
};

template <class Message, class Take>
void RobotIntake::arrive(std::string_view bytes, const Take& take) {
  const auto message = parse_cdr<Message>(bytes);
  arrive(Message::kType, [&] { return message && take(*message); });
}

}  // namespace aisle
