#include "aisle/formats/sessions/session_truth.hpp"

#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "sessions/frame_messages.hpp"

namespace aisle {

Result<Trajectory> read_true_poses(const std::filesystem::path& session) {
  auto reader = SessionReader::open(session);
  if (!reader) return reader.problems();
  Trajectory truth;
  while (true) {
    const auto message = reader->next();
    if (!message) return message.problems();
    if (!message->has_value()) return truth;
    if ((*message)->topic.name != kTruePoseTopic) continue;
    const auto pose = decoded<ros::PoseStamped>({(*message)->topic, std::string((*message)->cdr)},
                                                reader->database().string());
    if (!pose) return pose.problems();
    truth.stamps_s.push_back(ros::stamp_s((*message)->stamp));
    truth.T_map_vehicle.push_back(
        {pose->pose.position.x, pose->pose.position.y, yaw_of(pose->pose.orientation)});
  }
}

}  // namespace aisle
