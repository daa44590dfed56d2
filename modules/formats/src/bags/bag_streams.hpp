#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/bags/bag_scan.hpp"
#include "aisle/formats/bags/transform_tree.hpp"
#include "bags/topic_choice.hpp"

namespace aisle {

struct BagPose {
  MessageTime time;
  Pose2 T_parent_child;
};

/// Poses of one frame in another, in the order of recording.
struct BagMotion {
  std::string source;  ///< the topic
  std::string parent, child;
  std::vector<BagPose> poses;
};

/// What is kept of images until they are read: when each was taken.
struct BagImages {
  std::string frame;  ///< of the first
  std::vector<MessageTime> times;
  std::optional<ros::CameraInfo> calibration;  ///< the first that is one
};

/// The messages of the chosen topics of a bag.
struct BagStreams {
  std::vector<std::vector<BagScan>> scans;                ///< of each topic of scans
  std::vector<std::map<std::string, ScanDoubts>> doubts;  ///< of each topic of scans, by frame
  BagImages images;
  BagMotion odometry;  ///< of the chosen topic
  BagMotion pose;      ///< of the chosen topic of poses
  std::map<std::pair<std::string, std::string>, BagMotion>
      by_transforms;  ///< odom -> something, by both frames
  TransformTree transforms;
};

/// Reads the bag once. Messages that cannot be read are left out with a warning.
Result<BagStreams> read_streams(BagReader& bag, const TopicChoice& choice, const std::string& file,
                                Problems& warnings);

}  // namespace aisle
