#include "aisle/formats/bags/bag_overview.hpp"

#include <algorithm>

#include "aisle/formats/bags/bag_scan.hpp"
#include "bags/topic_choice.hpp"

namespace aisle {
namespace {

constexpr std::size_t kFramesMax = 20;

std::string arrow(const std::string& parent, const std::string& child) {
  return frame_name(parent) + (child.empty() ? "" : " -> " + frame_name(child));
}

std::vector<std::string> frames_in(const BagReader::Message& message, const BagTopic& topic) {
  std::vector<std::string> frames;
  if (use_of(topic) == TopicUse::kTransforms) {
    const auto transforms = parse_message<ros::TFMessage>(message.bytes, topic.encoding);
    for (const auto& stamped : transforms ? transforms->transforms : std::vector<ros::TransformStamped>())
      frames.push_back(arrow(stamped.header.frame_id, stamped.child_frame_id));
  } else if (use_of(topic) == TopicUse::kOdometry) {
    if (const auto odometry = parse_message<ros::Odometry>(message.bytes, topic.encoding))
      frames.push_back(arrow(odometry->header.frame_id, odometry->child_frame_id));
  } else if (use_of(topic) != TopicUse::kNone && topic.type != ros::Pose::kType) {
    if (const auto header = parse_header(message.bytes, topic.encoding))
      frames.push_back(frame_name(header->frame_id));
  }
  return frames;
}

void add(const BagReader::Message& message, long count, BagOverview::Topic& topic) {
  topic.first = count == 1 ? message.log_stamp : std::min(topic.first, message.log_stamp);
  topic.last = count == 1 ? message.log_stamp : std::max(topic.last, message.log_stamp);
  for (const std::string& frame : frames_in(message, topic.topic)) {
    const bool is_known = std::find(topic.frames.begin(), topic.frames.end(), frame) != topic.frames.end();
    if (!is_known && topic.frames.size() < kFramesMax) topic.frames.push_back(frame);
  }
}

}  // namespace

std::string served_by(const BagTopic& topic) {
  if (is_truth(topic)) return "not read";
  switch (use_of(topic)) {
    case TopicUse::kScan:
      return "scan";
    case TopicUse::kOdometry:
    case TopicUse::kPose:
      return "odometry";
    case TopicUse::kImages:
      return "camera";
    case TopicUse::kCalibration:
      return "lens";
    case TopicUse::kTransforms:
      return "mounts";
    case TopicUse::kNone:
      break;
  }
  return "not read";
}

Result<BagOverview> bag_overview(const std::filesystem::path& path) {
  auto bag = BagReader::open(path);
  if (!bag) return bag.problems();
  BagOverview overview;
  for (const BagTopic& topic : bag->topics())
    overview.topics.push_back({.topic = topic, .serves = served_by(topic)});
  std::vector<long> counts(overview.topics.size());
  while (true) {
    const auto message = bag->next();
    if (!message) return message.problems();
    if (!*message) break;
    const std::size_t topic = (*message)->topic;
    if (topic >= counts.size()) continue;  // the bag's own summary does not know it
    add(**message, ++counts[topic], overview.topics[topic]);
    const ros::Stamp_ns stamp = (*message)->log_stamp;
    overview.first = overview.messages == 0 ? stamp : std::min(overview.first, stamp);
    overview.last = overview.messages == 0 ? stamp : std::max(overview.last, stamp);
    ++overview.messages;
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    BagOverview::Topic& topic = overview.topics[i];
    topic.topic.messages = counts[i];
    const double length_s = static_cast<double>(topic.last - topic.first) * 1e-9;
    if (length_s > 0) topic.rate_hz = static_cast<double>(counts[i] - 1) / length_s;
  }
  overview.warnings = bag->warnings();
  return overview;
}

}  // namespace aisle
