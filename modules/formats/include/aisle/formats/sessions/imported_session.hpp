#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/image_sequences/image_sequence.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "aisle/formats/sessions/timed_scans.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct RecordedMessage;

/// The navigator of sessions that another program recorded: nobody decided in them.
inline constexpr const char* kImportedNavigator = "imported";

/// What the recording or the user tells of the vehicle's sensors; the rest of the description is
/// placeholders.
struct KnownSensors {
  bool lens = false;           ///< of the camera
  bool mount = false;          ///< of the camera
  bool scanner_mount = false;  ///< the beams of the scanner are always known

  /// Whether the vehicle's camera is the real one; without a camera, whether its scanner is.
  bool is_calibrated(const VehicleDescription& vehicle) const {
    return vehicle.cameras.empty() ? scanner_mount : lens && mount;
  }
};

/// Writes what a recording holds as a session: images byte for byte, scans, odometry. The session is in its
/// place only after finish(): until then it grows in a hidden folder beside it, which is removed if the work
/// ends before, and which the next import to this place takes over if the process was killed.
class ImportedSession {
 public:
  /// `directory`, `force` and `storage` as in SessionWriter::create.
  /// @param camera  a camera of the vehicle: what the images are of; empty if there are none
  /// @param known   of the sensors; viewers get no calibration and frames that nobody knows
  /// @param has_odometry  whether images and scans have it
  static Result<ImportedSession> create(const std::filesystem::path& directory, bool force,
                                        const VehicleDescription& vehicle, const std::string& camera,
                                        const KnownSensors& known, bool has_odometry,
                                        SessionStorage storage = SessionStorage::kSqlite);

  ImportedSession(ImportedSession&&) noexcept = default;
  ImportedSession& operator=(ImportedSession&&) noexcept = delete;
  ~ImportedSession();

  /// The moments come in the order of their stamps, each later than the one before. Empty on success.
  Problems take(const TimedImage& image);
  Problems take(const TimedScan& scan);

  /// Puts the session into its place. Empty on success.
  Problems finish();

  /// How far the path by the wheels' readings was from the recorded one at worst: a vehicle on wheels cannot
  /// move sideways.
  double sideways_m() const { return sideways_m_; }

 private:
  ImportedSession(std::filesystem::path directory, SessionWriter writer, VehicleDescription vehicle,
                  std::string camera, const KnownSensors& known, bool has_odometry);

  Problems write_head(ros::Stamp_ns stamp);
  Problems write(ros::Stamp_ns stamp, std::vector<RecordedMessage> messages,
                 const std::optional<Pose2>& T_odom_vehicle);
  Problems write_odometry(ros::Stamp_ns stamp, const Pose2& T_odom_vehicle);

  std::filesystem::path directory_;
  std::unique_ptr<SessionWriter> writer_;  ///< null: moved away, or finished
  VehicleDescription vehicle_;
  std::string camera_;
  KnownSensors known_;
  bool has_odometry_;
  std::optional<ros::Stamp_ns> last_stamp_;
  Pose2 T_odom_start_;
  Pose2 T_start_vehicle_;  ///< by the wheels' readings
  double sideways_m_ = 0;
};

}  // namespace aisle
