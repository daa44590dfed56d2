#include "bags/bag_streams.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {
namespace {

/// "odom" and "robot_1/odom", but neither "map" nor "base_link".
bool is_odometry_frame(const std::string& frame) {
  return frame.substr(frame.rfind('/') + 1).find("odom") != std::string::npos;
}

class StreamIntake {
 public:
  StreamIntake(const BagReader& bag, const TopicChoice& choice) : bag_(bag), choice_(choice) {
    streams_.scans.resize(choice.scans.size());
    streams_.doubts.resize(choice.scans.size());
    if (choice.odometry) streams_.odometry.source = bag.topics()[*choice.odometry].name;
    if (choice.pose) streams_.pose.source = bag.topics()[*choice.pose].name;
  }

  void take(const BagReader::Message& message) {
    const BagTopic& topic = bag_.topics()[message.topic];
    const auto scan = std::find(choice_.scans.begin(), choice_.scans.end(), message.topic);
    bool is_good = false;
    if (scan != choice_.scans.end())
      is_good = take_scan(message, topic.encoding, static_cast<std::size_t>(scan - choice_.scans.begin()));
    else if (message.topic == choice_.images)
      is_good = take_image(message, topic.encoding);
    else if (message.topic == choice_.calibration)
      is_good = take_calibration(message, topic.encoding);
    else if (use_of(topic) == TopicUse::kTransforms)
      is_good = take_transforms(message, topic);
    else
      is_good =
          take_pose(message, topic, message.topic == choice_.odometry ? streams_.odometry : streams_.pose);
    if (!is_good) ++bad_[message.topic];
  }

  void tell_bad(const std::string& file, Problems& warnings) const {
    for (const auto& [topic, messages] : bad_)
      warnings.push_back({{file, 0, bag_.topics()[topic].name},
                          fmt::format("{} of {} messages are left out, for they cannot be read as {}",
                                      messages, bag_.topics()[topic].messages, bag_.topics()[topic].type)});
  }

  BagStreams streams() && { return std::move(streams_); }

 private:
  bool take_scan(const BagReader::Message& message, BagEncoding encoding, std::size_t laser) {
    const auto scan = parse_message<ros::LaserScan>(message.bytes, encoding);
    if (!scan) return false;
    auto taken = bag_scan(*scan, time_of(message, scan->header),
                          streams_.doubts[laser][frame_name(scan->header.frame_id)]);
    if (!taken) return false;
    streams_.scans[laser].push_back(std::move(*taken));
    return true;
  }

  bool take_image(const BagReader::Message& message, BagEncoding encoding) {
    const auto header = parse_header(message.bytes, encoding);
    if (!header) return false;
    BagImages& images = streams_.images;
    if (images.times.empty()) images.frame = frame_name(header->frame_id);
    images.times.push_back(time_of(message, *header));
    return true;
  }

  /// Cameras that were never calibrated publish zeros.
  bool take_calibration(const BagReader::Message& message, BagEncoding encoding) {
    if (streams_.images.calibration) return true;
    auto calibration = parse_message<ros::CameraInfo>(message.bytes, encoding);
    if (!calibration) return false;
    if (calibration->k.front() != 0) streams_.images.calibration = std::move(*calibration);
    return true;
  }

  bool take_transforms(const BagReader::Message& message, const BagTopic& topic) {
    const auto transforms = parse_message<ros::TFMessage>(message.bytes, topic.encoding);
    if (!transforms) return false;
    bool is_good = true;
    for (const ros::TransformStamped& stamped : transforms->transforms) {
      const auto T = isometry(stamped.transform.translation, stamped.transform.rotation);
      const std::string parent = frame_name(stamped.header.frame_id),
                        child = frame_name(stamped.child_frame_id);
      is_good &= T.has_value();
      if (!T) continue;
      streams_.transforms.add(parent, child, *T);
      if (!is_odometry_frame(parent) || topic.name.ends_with("tf_static")) continue;
      BagMotion& motion = streams_.by_transforms[{parent, child}];
      if (motion.poses.empty()) motion = {topic.name, parent, child, {}};
      motion.poses.push_back({time_of(message, stamped.header), in_the_plane(*T)});
    }
    return is_good;
  }

  bool take_pose(const BagReader::Message& message, const BagTopic& topic, BagMotion& motion) {
    ros::Header header;
    std::string child;
    std::optional<Eigen::Isometry3d> T;
    const auto read = [&]<class Type>(auto pose_of) {
      const auto parsed = parse_message<Type>(message.bytes, topic.encoding);
      if (parsed) pose_of(*parsed);
    };
    const auto take = [&](const ros::Pose& pose) { T = isometry(pose.position, pose.orientation); };
    if (topic.type == ros::Odometry::kType) {
      read.operator()<ros::Odometry>(
          [&](const auto& m) { header = m.header, child = m.child_frame_id, take(m.pose.pose); });
    } else if (topic.type == ros::PoseStamped::kType) {
      read.operator()<ros::PoseStamped>([&](const auto& m) { header = m.header, take(m.pose); });
    } else if (topic.type == ros::PoseWithCovarianceStamped::kType) {
      read.operator()<ros::PoseWithCovarianceStamped>(
          [&](const auto& m) { header = m.header, take(m.pose.pose); });
    } else if (topic.type == ros::TransformStamped::kType) {
      read.operator()<ros::TransformStamped>([&](const auto& m) {
        header = m.header, child = m.child_frame_id,
        T = isometry(m.transform.translation, m.transform.rotation);
      });
    } else {
      read.operator()<ros::Pose>([&](const auto& m) { take(m); });
    }
    if (!T) return false;
    if (motion.poses.empty()) {
      motion.parent = frame_name(header.frame_id);
      motion.child = frame_name(child);
    }
    motion.poses.push_back({time_of(message, header), in_the_plane(*T)});
    return true;
  }

  static MessageTime time_of(const BagReader::Message& message, const ros::Header& header) {
    return {ros::stamp_ns(header.stamp), message.log_stamp, message.number};
  }

  const BagReader& bag_;
  const TopicChoice& choice_;
  BagStreams streams_;
  std::map<std::size_t, long> bad_;
};

}  // namespace

Result<BagStreams> read_streams(BagReader& bag, const TopicChoice& choice, const std::string& file,
                                Problems& warnings) {
  std::vector<std::size_t> wanted = choice.scans;
  wanted.insert(wanted.end(), choice.transforms.begin(), choice.transforms.end());
  for (const auto& topic : {choice.images, choice.calibration, choice.odometry, choice.pose}) {
    if (topic) wanted.push_back(*topic);
  }
  bag.want(wanted);
  StreamIntake intake(bag, choice);
  while (true) {
    const auto message = bag.next();
    if (!message) return message.problems();
    if (!*message) break;
    intake.take(**message);
  }
  intake.tell_bad(file, warnings);
  return std::move(intake).streams();
}

}  // namespace aisle
