#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "aisle/connection/connection_counts.hpp"
#include "aisle/connection/topic_pace.hpp"
#include "aisle/formats/bags/bag_scan.hpp"
#include "aisle/formats/bags/transform_tree.hpp"
#include "odometry_trail.hpp"

namespace aisle {

inline constexpr double kNever_s = -std::numeric_limits<double>::infinity();

/// What a bumper or an emergency stop says.
struct SwitchState {
  bool is_pressed = false;
  bool was_pressed = false;  ///< since the last observation
  double arrived_s = kNever_s;
};

/// What a robot has said so far. Stamps are by the clock that the connection names, arrivals by aisle's own.
struct RobotState {
  explicit RobotState(const OdometryTrail& empty_trail) : trail(empty_trail) {}

  std::deque<BagScan> scans;  ///< not yet taken; the newest last
  std::string scan_frame;     ///< of the first scan; others are not taken
  double scan_arrived_s = kNever_s;
  TopicPace scan_pace;
  std::optional<double> newest_scan_s;
  double newest_scan_end_s = kNever_s;
  std::vector<double> scan_periods_s;  ///< of the first scans

  OdometryTrail trail;
  double odometry_arrived_s = kNever_s;
  TopicPace odometry_pace;
  double leap_arrived_s = kNever_s;

  TransformTree transforms;
  std::vector<SwitchState> bumpers;          ///< as in the connection
  std::vector<SwitchState> emergency_stops;  ///< as in the connection
  std::optional<double> charge;              ///< of the battery, 0 to 1
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
