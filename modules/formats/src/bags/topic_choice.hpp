#pragma once
/// Which topics of a bag are its scans and its odometry.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// What a topic could serve for, by its type and name.
enum class TopicUse { kNone, kScan, kOdometry, kPose, kCamera, kTransforms };

TopicUse use_of(const BagTopic& topic);

/// Whether a topic holds what a simulation or a measuring system knows, which no vehicle does.
bool is_truth(const BagTopic& topic);

/// "it has: /scan (sensor_msgs/msg/LaserScan, 357), ..."
std::string topic_list(const std::vector<BagTopic>& topics);

struct TopicChoice {
  std::vector<std::size_t> scans;       ///< at least one
  std::optional<std::size_t> odometry;  ///< nav_msgs/Odometry, or what the options name
  std::optional<std::size_t> pose;      ///< to be taken if there is no odometry
  std::vector<std::size_t> transforms;
  bool by_transforms_only = false;  ///< the options want /tf
};

/// Reads the beginning of the bag if more than one topic has scans.
Result<TopicChoice> choose_topics(BagReader& bag, const RecordingOptions& options, const std::string& file,
                                  Problems& warnings);

}  // namespace aisle
