#pragma once
/// What a LaserScan message says in aisle's terms.

#include <optional>
#include <string>
#include <vector>

#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// When a message was made and recorded.
struct MessageTime {
  ros::Stamp_ns stamp = 0;  ///< of its header
  ros::Stamp_ns log_stamp = 0;
  long number = 0;  ///< in the bag
};

struct BagScan {
  MessageTime time;
  std::string frame;
  std::vector<float> ranges_m;  ///< 0: nothing usable; infinite: nothing in range
  ScanBeams beams;              ///< period_s has the sign of the turn; stated or 0
  double scan_time_s = 0;       ///< as stated
  double range_max_m = 0;       ///< as stated
};

/// What many scans had to be forgiven.
struct ScanDoubts {
  long readings = 0;
  long not_numbers = 0;     ///< nan, -inf, negative
  long too_near = 0;        ///< below range_min
  long too_far = 0;         ///< finite, beyond range_max
  long angles_by_step = 0;  ///< scans whose angle_max disagrees with the number of their readings
  long angles_by_view = 0;  ///< scans whose angle_increment is rounded
  long first_by_view = 0;   ///< number of the first such message
};

/// A name of a frame without the slash that old ROS puts in front.
std::string frame_name(const std::string& frame_id);

/// The scan with its readings counter-clockwise.
/// @return nullopt if its angles are no numbers, or it has fewer than two readings
std::optional<BagScan> bag_scan(const ros::LaserScan& message, const MessageTime& time, ScanDoubts& doubts);

/// The scan of a scanner that hangs upside down, as seen from above.
void turn_over(BagScan& scan);

}  // namespace aisle
