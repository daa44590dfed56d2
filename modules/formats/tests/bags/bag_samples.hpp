#pragma once
/// A small recording of a vehicle with a scanner, as messages that a test may change.

#include <functional>
#include <string>
#include <vector>

#include "aisle/formats/bags/laser_bag.hpp"
#include "bag_writers.hpp"
#include "session_samples.hpp"

namespace aisle {

inline ros::LaserScan five_beams(double stamp_s, const std::string& frame = "laser") {
  ros::LaserScan scan;
  scan.header = {ros::time_of(ros::stamp_ns(stamp_s)), frame};
  scan.angle_min = -1;
  scan.angle_max = 1;
  scan.angle_increment = 0.5F;
  scan.range_min = 0.1F;
  scan.range_max = 10;
  scan.ranges = {1, 2, 3, 4, 5};
  return scan;
}

inline ros::Odometry odometry_at(double stamp_s, double x) {
  ros::Odometry odometry;
  odometry.header = {ros::time_of(ros::stamp_ns(stamp_s)), "odom"};
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.position.x = x;
  return odometry;
}

inline ros::TransformStamped transform(const std::string& parent, const std::string& child,
                                       const ros::Vector3& translation, const ros::Quaternion& rotation = {},
                                       double stamp_s = 0) {
  return {{ros::time_of(ros::stamp_ns(stamp_s)), parent}, child, {translation, rotation}};
}

/// Ten scans and eleven odometry samples, 0.1 s apart, with the mount of the scanner.
struct Recorded {
  std::function<void(ros::LaserScan&, int)> change_scan = [](auto&, int) {};
  std::function<void(ros::Odometry&, int)> change_odometry = [](auto&, int) {};
  bool has_odometry = true;
  bool has_mount = true;
  ros::Quaternion mount = {};

  std::vector<WrittenMessage> messages(Written as = Written::kCdr) const {
    std::vector<WrittenMessage> all;
    if (has_mount) {
      all.push_back(
          written("/tf_static", 100, ros::TFMessage{{transform("plate", "laser", {0.1, 0, 0}, mount)}}, as));
      all.push_back(
          written("/tf_static", 100, ros::TFMessage{{transform("base_link", "plate", {0.2, 0, 0.5})}}, as));
    }
    for (int i = 0; i <= 10; ++i) {
      const double time_s = 100 + 0.1 * i;
      ros::Odometry odometry = odometry_at(time_s, 0.05 * i);
      change_odometry(odometry, i);
      if (has_odometry) all.push_back(written("/odom", time_s + 0.01, odometry, as));
      if (i == 10) break;
      ros::LaserScan scan = five_beams(time_s);
      change_scan(scan, i);
      all.push_back(written("/scan", time_s + 0.02, scan, as));
    }
    return all;
  }
};

inline Result<LaserRecording> read_messages(const std::vector<WrittenMessage>& messages,
                                            const RecordingOptions& options = {}) {
  const SessionPlace place;
  write_file(place / "bag.mcap", mcap_bytes(messages));
  return read_laser_bag(place / "bag.mcap", options);
}

inline std::string trouble(const Result<LaserRecording>& result) {
  return result ? "" : to_string(result.problems());
}

}  // namespace aisle
