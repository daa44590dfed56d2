#include "aisle/formats/sessions/imported_session.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "sessions/frame_messages.hpp"
#include "sessions/image_messages.hpp"
#include "sessions/observation_messages.hpp"
#include "sessions/session_files.hpp"
#include "sessions/wheels_of_motion.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

/// The directory with its own name last: not "drive/" or ".".
fs::path named(const fs::path& directory) {
  fs::path whole = fs::absolute(directory).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Hidden, so that no list of sessions shows it.
fs::path folder_of_unfinished(const fs::path& directory) {
  return directory.parent_path() / ("." + directory.filename().string() + ".importing");
}

/// Of the name that it will have, because its database is called after it.
fs::path unfinished(const fs::path& directory) {
  return folder_of_unfinished(directory) / directory.filename();
}

RecordedMessage controls_message(ros::Stamp_ns stamp, const RecordedControls& controls) {
  ros::JointState message;
  message.header.stamp = ros::time_of(stamp);
  message.name = {"steering", "throttle"};
  message.position = {controls.steering, controls.throttle};
  return recorded(kControlsTopic, message);
}

Problems write_all(SessionWriter& writer, ros::Stamp_ns stamp, std::span<const RecordedMessage> messages) {
  for (const auto& [topic, cdr] : messages) {
    if (Problems problems = writer.write(topic, stamp, cdr); !problems.empty()) return problems;
  }
  return {};
}

}  // namespace

ImportedSession::ImportedSession(fs::path directory, SessionWriter writer, VehicleDescription vehicle,
                                 std::string camera, const KnownSensors& known, bool has_odometry)
    : directory_(std::move(directory)),
      writer_(std::make_unique<SessionWriter>(std::move(writer))),
      vehicle_(std::move(vehicle)),
      camera_(std::move(camera)),
      known_(known),
      has_odometry_(has_odometry) {}

Result<ImportedSession> ImportedSession::create(const fs::path& directory, bool force,
                                                const VehicleDescription& vehicle, const std::string& camera,
                                                const KnownSensors& known, bool has_odometry,
                                                SessionStorage storage) {
  if (auto read_back = parse_vehicle(vehicle_yaml(vehicle), "the vehicle's description"); !read_back)
    return read_back.problems();
  if (Problems problems = prepare_directory(directory, force); !problems.empty()) return problems;
  const fs::path place = named(directory);
  auto writer = SessionWriter::create(unfinished(place), true, storage);
  if (!writer) return writer.problems();
  return ImportedSession(place, std::move(*writer), vehicle, camera, known, has_odometry);
}

ImportedSession::~ImportedSession() {
  if (!writer_) return;
  writer_->discard();
  std::error_code error;
  fs::remove(folder_of_unfinished(directory_), error);
  fs::remove(directory_, error);
}

/// Frames and calibration are left out where they would be inventions.
Problems ImportedSession::write_head(ros::Stamp_ns stamp) {
  SessionOrigin origin{.navigator = kImportedNavigator, .parameters = {}};
  origin.has_odometry = has_odometry_;
  origin.has_calibration = known_.is_calibrated(vehicle_);
  std::vector<RecordedMessage> head = {latched(kOriginTopic, ros::String{session_origin_json(origin)}),
                                       latched(kVehicleTopic, ros::String{vehicle_yaml(vehicle_)})};
  VehicleDescription placed = vehicle_;
  if (!known_.mount) placed.cameras.clear();
  if (!known_.scanner_mount) placed.scanner.reset();
  if (!placed.cameras.empty() || placed.scanner) head.push_back(static_frames_message(stamp, placed));
  return write_all(*writer_, stamp, head);
}

Problems ImportedSession::take(const TimedImage& image) {
  std::vector<RecordedMessage> messages = {image_file_message(camera_, image.stamp_s, image.bytes)};
  const CameraDescription* camera = vehicle_.camera(camera_);
  if (known_.lens && camera != nullptr) messages.push_back(camera_info_message(*camera, image.stamp_s));
  const ros::Stamp_ns stamp = ros::stamp_ns(image.stamp_s);
  if (image.controls) messages.push_back(controls_message(stamp, *image.controls));
  return write(stamp, std::move(messages), image.T_odom_vehicle);
}

Problems ImportedSession::take(const TimedScan& scan) {
  const LaserScanner scanner = vehicle_.scanner.value_or(LaserScanner{});
  return write(ros::stamp_ns(scan.stamp_s), {scan_message(scan.scan, scanner, scan.reading_period_s)},
               scan.T_odom_vehicle);
}

/// The messages of one cycle.
Problems ImportedSession::write(ros::Stamp_ns stamp, std::vector<RecordedMessage> messages,
                                const std::optional<Pose2>& T_odom_vehicle) {
  if (!last_stamp_) {
    if (Problems problems = write_head(stamp); !problems.empty()) return problems;
  }
  if (Problems problems = write_all(*writer_, stamp, messages); !problems.empty()) return problems;
  if (T_odom_vehicle) {
    if (Problems problems = write_odometry(stamp, *T_odom_vehicle); !problems.empty()) return problems;
  }
  last_stamp_ = stamp;
  return {};
}

/// Each reading leads from where the readings before led to where the vehicle was, so that neither rounding
/// nor small sideways motions add up.
Problems ImportedSession::write_odometry(ros::Stamp_ns stamp, const Pose2& T_odom_vehicle) {
  if (!last_stamp_) T_odom_start_ = T_odom_vehicle;
  const Pose2 T_start_recorded = T_odom_start_.inverse() * T_odom_vehicle;
  const OdometryReading reading = wheels_of(vehicle_, T_start_vehicle_.inverse() * T_start_recorded);
  const Pose2 motion = odometry_step(vehicle_, reading);
  T_start_vehicle_ = T_start_vehicle_ * motion;
  sideways_m_ = std::max(sideways_m_, std::hypot(T_start_vehicle_.x - T_start_recorded.x,
                                                 T_start_vehicle_.y - T_start_recorded.y));
  const double duration_s = last_stamp_ ? static_cast<double>(stamp - *last_stamp_) / 1e9 : 0;
  const std::array messages = {wheels_message(stamp, reading),
                               odometry_message(stamp, T_start_vehicle_, motion, duration_s),
                               frames_message(stamp, T_start_vehicle_)};
  return write_all(*writer_, stamp, messages);
}

Problems ImportedSession::finish() {
  if (Problems problems = writer_->close(); !problems.empty()) return problems;
  std::error_code error;
  fs::remove(directory_, error);
  fs::rename(unfinished(directory_), directory_, error);
  if (error) return {{{directory_.string()}, "cannot be put in place: " + error.message()}};
  writer_.reset();
  fs::remove(folder_of_unfinished(directory_), error);
  return {};
}

}  // namespace aisle
