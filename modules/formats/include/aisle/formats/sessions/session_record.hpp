#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "aisle/formats/images/image_coding.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct RecordedMessage;

/// Writes a mission's cycles to a session, passes them to a watcher, or both. All messages of a cycle have
/// the stamp of its observation, so a session whose recording was killed ends with a complete cycle.
class SessionRecord final : public MissionRecord {
 public:
  /// `directory`, `force` and `storage` as in SessionWriter::create.
  static Result<SessionRecord> create(const std::filesystem::path& directory, bool force,
                                      const VehicleDescription& vehicle, const SessionOrigin& origin,
                                      const ImageCoding& coding = {},
                                      SessionStorage storage = SessionStorage::kSqlite);

  /// Writes nothing: all messages only go to `watcher`, which must outlive the record.
  static Result<SessionRecord> shown(MessageSink& watcher, const VehicleDescription& vehicle,
                                     const SessionOrigin& origin, const ImageCoding& coding = {});

  /// From now on `watcher` also receives what is written, except the truth; it must outlive the record.
  void show_to(MessageSink& watcher) { watcher_ = &watcher; }
  /// The watcher, or null if there is none.
  MessageSink* watcher() const { return watcher_; }

  /// The vehicle as a replay will read it back. Build the navigator from this one, so that it sees the same
  /// vehicle in both.
  const VehicleDescription& vehicle() const { return vehicle_; }

  /// @return the observation as a replay will read it back
  /// @throws std::invalid_argument if the stamp is not at least a nanosecond later than the last one, any
  ///         stamp is not within 0 to 2^31 s, or a camera image is empty
  Result<Observation> keep(Observation observation) override;

  /// @throws std::logic_error before the first observation
  Problems keep(const Decision& decision) override;

  /// Writes the goals that the mission drives to, as JSON, to /goals: for viewers.
  /// @throws std::logic_error before the first observation
  Problems keep_goals(const std::string& goals_json);

  /// Writes the vehicle's true pose to /truth/pose: for evaluation, never part of the observations.
  Problems keep_truth(double stamp_s, const Pose2& T_map_vehicle);

  /// Ends the session. The destructor does so too, but cannot report failure.
  Problems close() { return writer_ ? writer_->close() : Problems{}; }

 private:
  SessionRecord(std::optional<SessionWriter> writer, VehicleDescription vehicle, std::string vehicle_text,
                SessionOrigin origin, const ImageCoding& coding);

  Problems write_head(ros::Stamp_ns stamp);
  Problems write(ros::Stamp_ns stamp, std::span<const RecordedMessage> messages);
  Problems write_for_viewers(const Observation& observation, ros::Stamp_ns stamp);

  std::optional<SessionWriter> writer_;
  MessageSink* watcher_ = nullptr;
  VehicleDescription vehicle_;
  std::string vehicle_text_;
  SessionOrigin origin_;
  ImageCoding coding_;
  bool has_head_ = false;
  std::optional<ros::Stamp_ns> last_stamp_;
  Pose2 T_odom_vehicle_;
};

}  // namespace aisle
