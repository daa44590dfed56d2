#include "aisle/formats/sessions/session_record.hpp"

#include <fmt/format.h>

#include <span>
#include <stdexcept>
#include <utility>

#include "aisle/formats/sessions/decision_text.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "sessions/frame_messages.hpp"
#include "sessions/image_messages.hpp"
#include "sessions/observation_messages.hpp"

namespace aisle {
namespace {

/// The description as written to a session, and as read back from it.
struct DescribedVehicle {
  std::string text;
  VehicleDescription description;
};

Result<DescribedVehicle> as_described(const VehicleDescription& vehicle) {
  DescribedVehicle described{.text = vehicle_yaml(vehicle)};
  auto read_back = parse_vehicle(described.text, "the vehicle's description");
  if (!read_back) return read_back.problems();
  described.description = std::move(read_back->description);
  return described;
}

}  // namespace

Result<SessionRecord> SessionRecord::create(const std::filesystem::path& directory, bool force,
                                            const VehicleDescription& vehicle, const SessionOrigin& origin,
                                            const ImageCoding& coding, SessionStorage storage) {
  auto described = as_described(vehicle);
  if (!described) return described.problems();
  auto writer = SessionWriter::create(directory, force, storage);
  if (!writer) return writer.problems();
  return SessionRecord(std::move(*writer), std::move(described->description), std::move(described->text),
                       origin, coding);
}

Result<SessionRecord> SessionRecord::shown(MessageSink& watcher, const VehicleDescription& vehicle,
                                           const SessionOrigin& origin, const ImageCoding& coding) {
  auto described = as_described(vehicle);
  if (!described) return described.problems();
  SessionRecord record(std::nullopt, std::move(described->description), std::move(described->text), origin,
                       coding);
  record.show_to(watcher);
  return record;
}

SessionRecord::SessionRecord(std::optional<SessionWriter> writer, VehicleDescription vehicle,
                             std::string vehicle_text, SessionOrigin origin, const ImageCoding& coding)
    : writer_(std::move(writer)),
      vehicle_(std::move(vehicle)),
      vehicle_text_(std::move(vehicle_text)),
      origin_(std::move(origin)),
      coding_(coding) {}

Problems SessionRecord::write(ros::Stamp_ns stamp, std::span<const RecordedMessage> messages) {
  for (const RecordedMessage& message : messages) {
    if (watcher_ != nullptr) watcher_->take(message.topic, stamp, message.cdr);
    if (!writer_) continue;
    if (Problems problems = writer_->write(message.topic, stamp, message.cdr); !problems.empty())
      return problems;
  }
  return {};
}

/// Writes what a reader needs to understand the session, before everything else.
Problems SessionRecord::write_head(ros::Stamp_ns stamp) {
  if (std::exchange(has_head_, true)) return {};
  const RecordedMessage head[] = {latched(kOriginTopic, ros::String{session_origin_json(origin_)}),
                                  latched(kVehicleTopic, ros::String{vehicle_text_}),
                                  static_frames_message(stamp, vehicle_)};
  return write(stamp, head);
}

Result<Observation> SessionRecord::keep(Observation observation) {
  const ros::Stamp_ns stamp = ros::stamp_ns(observation.stamp_s);
  if (last_stamp_ && stamp <= *last_stamp_)
    throw std::invalid_argument(
        fmt::format("an observation at {} ns after one at {} ns", stamp, *last_stamp_));
  const auto messages = messages_of(observation, vehicle_, coding_);
  if (Problems problems = write_head(stamp); !problems.empty()) return problems;
  if (Problems problems = write(stamp, messages); !problems.empty()) return problems;
  if (Problems problems = write_for_viewers(observation, stamp); !problems.empty()) return problems;
  last_stamp_ = stamp;

  auto read_back = observation_of(stamp, messages, "the session");
  if (!read_back) return read_back.problems();
  return read_back->value();
}

Problems SessionRecord::write_for_viewers(const Observation& observation, ros::Stamp_ns stamp) {
  const Pose2 motion = odometry_step(vehicle_, observation.odometry);
  T_odom_vehicle_ = T_odom_vehicle_ * motion;
  const double duration_s = last_stamp_ ? static_cast<double>(stamp - *last_stamp_) / 1e9 : 0;
  std::vector<RecordedMessage> messages = {odometry_message(stamp, T_odom_vehicle_, motion, duration_s),
                                           frames_message(stamp, T_odom_vehicle_)};
  for (const CameraImage& image : observation.images) {
    if (const CameraDescription* camera = vehicle_.camera(image.camera))
      messages.push_back(camera_info_message(*camera, image.stamp_s));
  }
  return write(stamp, messages);
}

Problems SessionRecord::keep(const Decision& decision) {
  if (!last_stamp_) throw std::logic_error("a decision before the first observation");
  const RecordedMessage messages[] = {recorded(kDecisionTopic, ros::String{decision_text(decision)}),
                                      command_message(vehicle_, decision.command)};
  return write(*last_stamp_, messages);
}

Problems SessionRecord::keep_goals(const std::string& goals_json) {
  if (!last_stamp_) throw std::logic_error("goals before the first observation");
  const RecordedMessage messages[] = {latched(kGoalsTopic, ros::String{goals_json})};
  return write(*last_stamp_, messages);
}

Problems SessionRecord::keep_truth(double stamp_s, const Pose2& T_map_vehicle) {
  const ros::Stamp_ns stamp = ros::stamp_ns(stamp_s);
  if (Problems problems = write_head(stamp); !problems.empty()) return problems;
  if (watcher_ != nullptr) watcher_->take_truth(T_map_vehicle);
  if (!writer_) return {};
  const RecordedMessage message = true_pose_message(stamp, T_map_vehicle);
  return writer_->write(message.topic, stamp, message.cdr);
}

}  // namespace aisle
