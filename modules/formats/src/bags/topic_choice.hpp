#pragma once
/// Which topics of a bag are its scans, its images and its odometry.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// What a topic could serve for, by its type and name.
enum class TopicUse { kNone, kScan, kOdometry, kPose, kImages, kCalibration, kTransforms };

TopicUse use_of(const BagTopic& topic);

/// Whether a topic holds what a simulation or a measuring system knows, which no vehicle does.
bool is_truth(const BagTopic& topic);

/// "it has: /scan (sensor_msgs/msg/LaserScan, 357), ..."
std::string topic_list(const std::vector<BagTopic>& topics);

struct TopicChoice {
  std::vector<std::size_t> scans;
  std::optional<std::size_t> images;
  std::optional<std::size_t> calibration;  ///< of the camera that took the images
  std::optional<std::size_t> odometry;     ///< nav_msgs/Odometry, or what the options name
  std::optional<std::size_t> pose;         ///< to be taken if there is no odometry
  std::vector<std::size_t> transforms;
  bool by_transforms_only = false;  ///< the options want /tf
};

/// The topics of a recording of scans: at least one has scans. Reads the beginning of the bag if several
/// have.
Result<TopicChoice> choose_topics(BagReader& bag, const RecordingOptions& options, const std::string& file,
                                  Problems& warnings);

/// The topics of a recording of images, with its scans if it has any.
/// @param images  the topic; empty: the only one with images. Several are a problem that names them
Result<TopicChoice> choose_image_topics(BagReader& bag, const std::string& images,
                                        const RecordingOptions& options, const std::string& file,
                                        Problems& warnings);

}  // namespace aisle
