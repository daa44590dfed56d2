#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/connection/connection_counts.hpp"
#include "aisle/connection/topic_pace.hpp"
#include "aisle/core/image.hpp"
#include "aisle/formats/bags/bag_scan.hpp"
#include "aisle/formats/bags/transform_tree.hpp"
#include "joystick.hpp"
#include "odometry_trail.hpp"

namespace aisle {

inline constexpr double kNever_s = -std::numeric_limits<double>::infinity();

/// What a bumper or an emergency stop says.
struct SwitchState {
  bool is_pressed = false;
  bool was_pressed = false;  ///< since the last observation
  double arrived_s = kNever_s;

  /// @param silent_max_s  0: it may be silent
  bool is_silent(double silent_max_s, double now_s) const {
    return silent_max_s > 0 && now_s - arrived_s > silent_max_s;
  }
};

/// How a sensor's readings come.
struct StreamState {
  std::string frame;  ///< of the first; others are not taken
  double arrived_s = kNever_s;
  TopicPace pace;
  std::optional<double> newest_s;
  double newest_end_s = kNever_s;  ///< of a scan, when its last beam was measured
  std::vector<double> periods_s;   ///< of the first
};

/// An image as it came: most are replaced by newer ones before anybody wants their pixels.
struct ArrivedImage {
  double stamp_s = 0;
  std::string message;                  ///< empty: pixels came
  std::shared_ptr<const Image> pixels;  ///< null: a message came
};

struct ArrivingImages {
  StreamState stream;
  std::deque<ArrivedImage> images;  ///< not yet taken; the newest last
  std::optional<ros::CameraInfo> calibration;
};

/// What a robot has said so far. Stamps are by the clock that the connection names, arrivals by aisle's own.
struct RobotState {
  explicit RobotState(const OdometryTrail& empty_trail) : trail(empty_trail) {}

  StreamState scan;
  std::deque<BagScan> scans;            ///< not yet taken; the newest last
  std::vector<ArrivingImages> cameras;  ///< as in the connection

  OdometryTrail trail;
  double odometry_arrived_s = kNever_s;
  TopicPace odometry_pace;
  double leap_arrived_s = kNever_s;

  TransformTree transforms;
  std::vector<SwitchState> bumpers;          ///< as in the connection
  std::vector<SwitchState> emergency_stops;  ///< as in the connection
  std::optional<Joystick> joystick;          ///< none: nobody drives by one
  std::optional<double> charge;              ///< of the battery, 0 to 1
  double charge_arrived_s = kNever_s;        ///< by aisle's own clock
  std::optional<double> ros_clock_s;
  double ros_clock_skipped_s = 0;  ///< in jumps ahead, which are no time that passed
  double clock_arrived_s = kNever_s;

  std::map<std::string, int> unreadable_in_a_row;  ///< by type
  ConnectionCounts counts;
  std::string jump;          ///< the last one that was left out, of odometry or a clock
  double jump_s = kNever_s;  ///< when it arrived
  std::string broken;        ///< why what the robot says makes no sense any more; empty: it does
};

}  // namespace aisle
