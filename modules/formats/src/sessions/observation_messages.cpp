#include "sessions/observation_messages.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "aisle/formats/sessions/decision_text.hpp"
#include "sessions/image_messages.hpp"

namespace aisle {
namespace {

const std::vector<std::string> kFrontSteeredNames = {"distance_m", "steering_rad"};
const std::vector<std::string> kDifferentialNames = {"left_steps", "right_steps"};

bool is_step_count(double value) {
  return std::abs(value) <= std::numeric_limits<int>::max() && value == std::trunc(value);
}

Result<OdometryReading> reading_of(const RecordedMessage& message, const std::string& file) {
  const auto wheels = decoded<ros::JointState>(message, file);
  if (!wheels) return wheels.problems();
  const std::vector<double>& values = wheels->position;
  if (wheels->name == kFrontSteeredNames && values.size() == 2)
    return OdometryReading(FrontSteeredMotion{values[0], values[1]});
  if (wheels->name == kDifferentialNames && values.size() == 2 && is_step_count(values[0]) &&
      is_step_count(values[1]))
    return OdometryReading(WheelSteps{static_cast<int>(values[0]), static_cast<int>(values[1])});
  return Problem{{file, 0, kWheelsTopic},
                 fmt::format("is neither [{}] nor [{}] in whole steps", fmt::join(kFrontSteeredNames, ", "),
                             fmt::join(kDifferentialNames, ", "))};
}

Result<RangeScan> scan_of(const RecordedMessage& message, const std::string& file) {
  auto scan = decoded<ros::LaserScan>(message, file);
  if (!scan) return scan.problems();
  return RangeScan{ros::stamp_s(ros::stamp_ns(scan->header.stamp)), std::move(scan->ranges)};
}

Result<OperatorInput> operator_of(const RecordedMessage& message, const std::string& file) {
  const auto text = decoded<ros::String>(message, file);
  if (!text) return text.problems();
  auto input = parse_operator(text->data);
  if (!input) return Problem{{file, 0, kOperatorTopic}, "has a message that is not operator input"};
  return *std::move(input);
}

bool is_silent(const OperatorInput& input) {
  return !input.requested && input.marks.empty() && input.goal_changes.empty() && !input.quit;
}

/// Collects the messages of one cycle.
class ObservationReader {
 public:
  ObservationReader(ros::Stamp_ns stamp, const std::string& file) : file_(file) {
    observation_.stamp_s = ros::stamp_s(stamp);
  }

  Problems take(const RecordedMessage& message) {
    const std::string& topic = message.topic.name;
    if (topic == kWheelsTopic)
      return put(reading_of(message, file_), [this](auto&& reading) {
        observation_.odometry = reading;
        has_odometry_ = true;
      });
    if (topic == kScanTopic)
      return put(scan_of(message, file_), [this](auto scan) { observation_.scan = std::move(scan); });
    if (topic == kOperatorTopic) {
      return put(operator_of(message, file_),
                 [this](auto input) { observation_.operator_input = std::move(input); });
    }
    if (topic == kBumperTopic) {
      return put(decoded<ros::Bool>(message, file_),
                 [this](auto&& pressed) { observation_.bumper_pressed = pressed.data; });
    }
    if (const auto camera = camera_of(topic)) {
      return put(camera_image_of(message, *camera, file_),
                 [this](auto image) { observation_.images.push_back(std::move(image)); });
    }
    return {};
  }

  std::optional<Observation> result(bool needs_odometry) && {
    const bool is_cycle =
        has_odometry_ || (!needs_odometry && (!observation_.images.empty() || observation_.scan));
    if (!is_cycle) return std::nullopt;
    return std::move(observation_);
  }

 private:
  template <class Value, class Put>
  static Problems put(Result<Value> value, Put put_in) {
    if (!value) return value.problems();
    put_in(*std::move(value));
    return {};
  }

  const std::string& file_;
  Observation observation_;
  bool has_odometry_ = false;
};

}  // namespace

RecordedMessage scan_message(const RangeScan& scan, const LaserScanner& scanner, double reading_period_s) {
  constexpr float kRangeMin_m = 0.001F;  // so that viewers, too, read 0 as "nothing usable"
  const std::size_t last = scan.ranges_m.empty() ? 0 : scan.ranges_m.size() - 1;
  ros::LaserScan message;
  message.header = {ros::time_of(ros::stamp_ns(scan.stamp_s)), "laser"};
  message.angle_min = static_cast<float>(scanner.first_angle_rad);
  message.angle_max = static_cast<float>(scanner.beam_angle(last));
  message.angle_increment = static_cast<float>(scanner.angle_step_rad);
  message.time_increment = static_cast<float>(reading_period_s);
  message.range_min = kRangeMin_m;
  message.range_max = static_cast<float>(scanner.range_max_m);
  message.ranges = scan.ranges_m;
  return recorded(kScanTopic, message);
}

RecordedMessage wheels_message(ros::Stamp_ns stamp, const OdometryReading& reading) {
  ros::JointState message;
  message.header.stamp = ros::time_of(stamp);
  if (const auto* motion = std::get_if<FrontSteeredMotion>(&reading)) {
    message.name = kFrontSteeredNames;
    message.position = {motion->distance_m, motion->steering_rad};
  } else {
    const auto& steps = std::get<WheelSteps>(reading);
    message.name = kDifferentialNames;
    message.position = {static_cast<double>(steps.left), static_cast<double>(steps.right)};
  }
  return recorded(kWheelsTopic, message);
}

std::vector<RecordedMessage> messages_of(const Observation& observation, const VehicleDescription& vehicle,
                                         const ImageCoding& coding) {
  const ros::Stamp_ns stamp = ros::stamp_ns(observation.stamp_s);
  std::vector<RecordedMessage> messages;
  for (const CameraImage& image : observation.images) messages.push_back(image_message(image, coding));
  messages.push_back(wheels_message(stamp, observation.odometry));
  if (observation.scan)
    messages.push_back(scan_message(*observation.scan, vehicle.scanner.value_or(LaserScanner{})));
  if (!is_silent(observation.operator_input))
    messages.push_back(recorded(kOperatorTopic, ros::String{operator_text(observation.operator_input)}));
  messages.push_back(recorded(kBumperTopic, ros::Bool{observation.bumper_pressed}));
  return messages;
}

Result<std::optional<Observation>> observation_of(ros::Stamp_ns stamp,
                                                  std::span<const RecordedMessage> messages,
                                                  const std::string& file, bool has_odometry) {
  ObservationReader reader(stamp, file);
  for (const RecordedMessage& message : messages) {
    if (Problems problems = reader.take(message); !problems.empty()) return problems;
  }
  return std::move(reader).result(has_odometry);
}

}  // namespace aisle
