#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "aisle/formats/images/image_coding.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct RecordedMessage;

/// A mission's cycles kept as a session, shown to a watcher, or both. All messages of a cycle bear the stamp
/// of its observation, so a killed session ends with a whole cycle.
class SessionRecord final : public MissionRecord {
 public:
  /// `directory` and `force` as in SessionWriter::create.
  static Result<SessionRecord> create(const std::filesystem::path& directory, bool force,
                                      const VehicleDescription& vehicle, const SessionOrigin& origin,
                                      const ImageCoding& coding = {});

  /// Keeps nothing: everything only goes to `watcher`, who must outlive it.
  static Result<SessionRecord> shown(MessageSink& watcher, const VehicleDescription& vehicle,
                                     const SessionOrigin& origin, const ImageCoding& coding = {});

  /// From now on `watcher` is shown what is kept, but never the truth; must outlive the record.
  void show_to(MessageSink& watcher) { watcher_ = &watcher; }
  /// Who is shown it; null: nobody.
  MessageSink* watcher() const { return watcher_; }

  /// The vehicle as a replay will know it; who makes the navigator from this one sees the same in both.
  const VehicleDescription& vehicle() const { return vehicle_; }

  /// @throws std::invalid_argument if the stamp is not later than the last one by a nanosecond, any stamp is
  ///         not within 0 to 2^31 s, or an image has no image
  Result<Observation> keep(Observation observation) override;

  /// @throws std::logic_error before the first observation
  Problems keep(const Decision& decision) override;

  /// Keeps where the vehicle really was, on /truth/pose: for evaluation, never among the observations.
  Problems keep_truth(double stamp_s, const Pose2& T_map_vehicle);

  /// Ends the session; the destructor does, too, but cannot say whether that succeeded.
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
