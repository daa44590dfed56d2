#pragma once
/// Connection files: how a robot is reached over ROS 2; see docs/formats/connection.md.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/vehicle/camera_source.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The part of the network that a robot is in.
struct ConnectedNetwork {
  int domain = 0;                               ///< ROS_DOMAIN_ID
  std::string interface_address = "127.0.0.1";  ///< of this machine; nothing else is listened on
  std::vector<std::string> peers{"127.0.0.1"};  ///< IPv4, where the robot is looked for
  bool multicast = false;                       ///< also announces itself to robots that look for no peers
  std::string name_space;                       ///< in front of every topic's name that has no slash in front
};

/// Which clock orders what the robot sends.
enum class ConnectedClock {
  kStamps,  ///< the stamps of its messages
  kRos,     ///< the stamps; ages count on /clock: the robot is in a simulator
  kArrival  ///< when its messages arrive: for stamps that make no sense
};

struct ConnectedFrames {
  std::string base = "base_link";
  std::string odom = "odom";
  enum class Mounts {
    kTransforms,  ///< the places of scanner and cameras come from /tf_static
    kFile         ///< from the vehicle file
  } mounts = Mounts::kTransforms;
  Vec2 p_base_axle_m =
      Vec2::Zero();  ///< aisle's base_link, below the axle's middle, in the robot's base frame
};

struct ConnectedScan {
  std::string topic = "scan";  ///< empty: there is no scanner
  double silent_max_s = 1;     ///< longer: the mission ends
};

/// A camera: of the robot, by a topic, or one that aisle opens itself. Exactly one of topic and the source's
/// texts is given.
struct ConnectedCamera {
  std::string name = "front";  ///< as in the vehicle file
  std::string topic;           ///< of sensor_msgs/Image or CompressedImage
  enum class Messages {
    kAuto,  ///< compressed where the topic's name ends so
    kImage,
    kCompressed
  } messages = Messages::kAuto;
  std::string calibration;  ///< topic of sensor_msgs/CameraInfo; empty: beside the images
  CameraSource source;      ///< without topic
  double silent_max_s = 1;  ///< longer: the mission ends

  bool has_compressed_images() const;
  std::string calibration_topic() const;
};

struct ConnectedOdometry {
  std::string topic = "odom";
  enum class Source { kOdometry, kTransforms, kJointStates } source = Source::kOdometry;
  double silent_max_s = 0.25;  ///< longer: the vehicle stops; four times as long: the mission ends
  double jump_max_m = 0.2;     ///< between two messages; a longer one is no motion
  std::string left_joint = "left_wheel_joint";  ///< with kJointStates
  std::string right_joint = "right_wheel_joint";
};

/// A topic of std_msgs/Bool that says when to stop. Silent for too long counts as pressed.
struct ConnectedSwitch {
  std::string topic;
  double silent_max_s = 0;  ///< 0: a switch that reports its changes alone
};

struct ConnectedBattery {
  std::string topic;         ///< of sensor_msgs/BatteryState; empty: not watched
  double charge_min = 0.15;  ///< with less, no mission starts
};

/// A topic of sensor_msgs/Joy by which a person drives. Buttons and axes are counted from 0; a button of -1
/// is none.
struct ConnectedJoystick {
  std::string topic = "joy";
  int dead_man_button = 4;  ///< the robot moves only while it is held
  int speed_axis = 1;
  int turn_axis = 0;       ///< turn rate, or steering of the front wheels
  int place_button = 0;    ///< marks a place
  int end_button = 1;      ///< the drive ends
  double speed_mps = 0.3;  ///< at full deflection
  double turn_rate_rad_s = 30 * kDegree;
  double steering_rad = 25 * kDegree;
};

struct ConnectedCommands {
  std::string topic = "cmd_vel";
  enum class Kind {
    kAuto,  ///< what the robot reads there
    kTwist,
    kTwistStamped,
    kAckermann
  } kind = Kind::kAuto;
  double age_max_s = 0.3;  ///< an older decision of the mission is replaced by: stop
};

/// Limits below those of the vehicle file; 0: that of the vehicle.
struct ConnectedLimits {
  double speed_max_mps = 0;
  double reverse_speed_max_mps = 0;
  double turn_rate_max_rad_s = 0;
};

/// Everything that aisle must know to drive a robot over ROS 2.
struct Connection {
  std::string file;     ///< where it was read, for problems
  std::string vehicle;  ///< vehicle file, or name of a shipped vehicle; a path is relative to the file
  ConnectedNetwork network;
  ConnectedClock clock = ConnectedClock::kStamps;
  ConnectedFrames frames;
  ConnectedScan scan;
  std::vector<ConnectedCamera> cameras;
  ConnectedOdometry odometry;
  std::vector<ConnectedSwitch> bumpers;
  std::vector<ConnectedSwitch> emergency_stops;
  ConnectedBattery battery;
  ConnectedJoystick joystick;
  ConnectedCommands commands;
  ConnectedLimits limits;

  /// The name as ROS says it: "/j100/scan".
  std::string topic(const std::string& name) const;
};

/// Reads a connection file; all problems are reported together, each with its line and key.
Result<Connection> read_connection(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<Connection> parse_connection(const std::string& text, const std::string& name);

/// The text of a connection file, every key with its value.
std::string connection_yaml(const Connection& connection);

/// The limits of a vehicle that is driven over a connection.
/// @return problems if the connection allows more than the vehicle does
Result<DriveLimits> limits_over(const Connection& connection, const DriveLimits& of_vehicle);

}  // namespace aisle
