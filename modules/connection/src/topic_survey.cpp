#include "aisle/connection/topic_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "aisle/formats/sessions/ros_messages.hpp"
#include "command_messages.hpp"

namespace aisle {
namespace {

constexpr const char* kScan = "scan";
constexpr const char* kOdometry = "odometry";
constexpr const char* kCommand = "command";
constexpr const char* kCamera = "camera";
constexpr const char* kJoystick = "joystick";
constexpr const char* kBattery = "battery";
constexpr const char* kClock = "clock";
constexpr const char* kEmergencyStop = "emergency stop";
constexpr const char* kBumper = "bumper";

bool has_word(const std::string& name, const std::string& word) {
  return name.find(word) != std::string::npos;
}

/// What a topic of switches is, which its name alone says.
std::string use_of_switch(const std::string& name) {
  if (has_word(name, "stop")) return kEmergencyStop;
  if (has_word(name, "bump") || has_word(name, "contact")) return kBumper;
  return {};
}

std::string use_of(const SurveyedTopic& topic) {
  if (topic.subscribers > 0 && command_kind(topic.type)) return kCommand;
  if (topic.publishers == 0) return {};
  static const std::map<std::string, std::string> uses = {
      {ros::LaserScan::kType, kScan},       {ros::Odometry::kType, kOdometry},
      {ros::JointState::kType, "wheels"},   {ros::TFMessage::kType, "transforms"},
      {ros::Image::kType, kCamera},         {ros::CompressedImage::kType, kCamera},
      {ros::Joy::kType, kJoystick},         {ros::CameraInfo::kType, "calibration"},
      {ros::BatteryState::kType, kBattery}, {ros::Clock::kType, kClock}};
  if (topic.type == ros::Bool::kType) return use_of_switch(topic.name);
  const auto use = uses.find(topic.type);
  return use == uses.end() ? std::string() : use->second;
}

/// The topics of one use; those that a robot's own programs filter come after those of the robot itself.
std::vector<const SurveyedTopic*> topics_for(const std::vector<SurveyedTopic>& topics,
                                             const std::string& use) {
  std::vector<const SurveyedTopic*> found;
  for (const SurveyedTopic& topic : topics) {
    if (topic.use == use) found.push_back(&topic);
  }
  std::stable_sort(found.begin(), found.end(), [](const SurveyedTopic* a, const SurveyedTopic* b) {
    return a->name.size() < b->name.size();
  });
  return found;
}

/// Chooses one topic of a use.
class Choice {
 public:
  Choice(const std::vector<SurveyedTopic>& topics, Problems& warnings)
      : topics_(topics), warnings_(warnings) {}

  void take(const std::string& use, std::string& name) {
    const auto found = topics_for(topics_, use);
    if (found.empty()) return;
    name = found.front()->name;
    if (found.size() == 1) return;
    std::vector<std::string> others;
    for (std::size_t i = 1; i < found.size(); ++i) others.push_back(found[i]->name);
    warnings_.push_back(
        {{name}, fmt::format("was taken as the {}; there are also {}", use, fmt::join(others, ", "))});
  }

  /// All cameras; a camera that sends its images raw and compressed is taken as it sends them raw. The first
  /// is called as cameras of vehicle files mostly are.
  void take_cameras(std::vector<ConnectedCamera>& cameras) {
    std::set<std::string> taken;
    for (const SurveyedTopic* topic : topics_for(topics_, kCamera)) {
      ConnectedCamera camera;
      camera.topic = topic->name;
      camera.messages = topic->type == ros::Image::kType ? ConnectedCamera::Messages::kImage
                                                         : ConnectedCamera::Messages::kCompressed;
      const std::string images = topic->name.substr(0, topic->name.find("/compressed"));
      if (!taken.insert(images).second) continue;
      if (!cameras.empty()) camera.name = fmt::format("camera_{}", cameras.size() + 1);
      cameras.push_back(std::move(camera));
    }
  }

  void take_all(const std::string& use, std::vector<ConnectedSwitch>& switches) {
    for (const SurveyedTopic* topic : topics_for(topics_, use)) switches.push_back({topic->name, 0});
  }

 private:
  const std::vector<SurveyedTopic>& topics_;
  Problems& warnings_;
};

void require(const std::vector<SurveyedTopic>& topics, const std::string& use, const char* what,
             Problems& problems) {
  if (topics_for(topics, use).empty())
    problems.push_back({{"connect init"}, fmt::format("found no {}", what)});
}

}  // namespace

std::vector<SurveyedTopic> survey(const std::vector<WireEndpoint>& endpoints) {
  std::map<std::pair<std::string, std::string>, SurveyedTopic> topics;
  for (const WireEndpoint& endpoint : endpoints) {
    SurveyedTopic& topic = topics[{endpoint.topic, endpoint.type}];
    topic.name = endpoint.topic;
    topic.type = endpoint.type;
    if (endpoint.kind == WireEndpoint::Kind::kSubscriber) {
      ++topic.subscribers;
    } else {
      ++topic.publishers;
      topic.reliable |= endpoint.reliable;
      topic.latched |= endpoint.latched;
    }
  }
  std::vector<SurveyedTopic> surveyed;
  for (auto& [key, topic] : topics) {
    topic.use = use_of(topic);
    surveyed.push_back(std::move(topic));
  }
  return surveyed;
}

Result<Connection> suggested_connection(const std::vector<SurveyedTopic>& topics, Connection connection,
                                        Problems& warnings) {
  Problems problems;
  const bool has_scanner = !topics_for(topics, kScan).empty();
  if (!has_scanner)
    require(topics, kCamera, "scans (sensor_msgs/msg/LaserScan) and no camera (Image, CompressedImage)",
            problems);
  require(topics, kOdometry, "odometry (nav_msgs/msg/Odometry)", problems);
  require(topics, kCommand, "program that reads commands (Twist, TwistStamped, AckermannDriveStamped)",
          problems);
  if (!problems.empty()) return problems;
  Choice choice(topics, warnings);
  if (!has_scanner) connection.scan.topic.clear();
  choice.take(kScan, connection.scan.topic);
  choice.take_cameras(connection.cameras);
  choice.take(kJoystick, connection.joystick.topic);
  choice.take(kOdometry, connection.odometry.topic);
  choice.take(kCommand, connection.commands.topic);
  choice.take(kBattery, connection.battery.topic);
  choice.take_all(kEmergencyStop, connection.emergency_stops);
  choice.take_all(kBumper, connection.bumpers);
  if (!topics_for(topics, kClock).empty()) connection.clock = ConnectedClock::kRos;
  return connection;
}

}  // namespace aisle
