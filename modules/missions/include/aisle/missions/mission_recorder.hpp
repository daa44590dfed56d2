#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "aisle/control/path.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/missions/viewer_messages.hpp"
#include "aisle/vehicle/truth_source.hpp"

namespace aisle {

/// Records a mission in a session, if there is one, and the truth where it is known. What it shows has the
/// stamp of the latest observation.
class MissionRecorder : public MissionRecord {
 public:
  /// @param truth  null: unknown. All must outlive the recorder
  MissionRecorder(std::optional<SessionRecord>& session, const Vehicle& vehicle, const TruthSource* truth)
      : session_(session), vehicle_(vehicle), truth_(truth) {}

  Result<Observation> keep(Observation observation) override;
  Problems keep(const Decision& decision) override;

  double stamp_s() const { return stamp_s_; }        ///< of the latest observation
  double odometry_m() const { return odometry_m_; }  ///< distance travelled, as the wheels counted it
  std::size_t images() const { return images_; }

 protected:
  /// These show to the watcher, without recording: the estimated pose, the planned path, how well the view
  /// matches the map, and what was detected in the cycle's first image.
  void show_pose(const UncertainPose2& T_map_vehicle) const;
  void show_plan(const Path& path) const;
  void show_match(const ViewMatch& match) const;
  void show_overlay(const Overlay& overlay) const;
  /// Shows the floor as known now: at most every two seconds, and only if it changed.
  void show_floor(const FloorGrid& floor);
  void show(const SessionTopic& topic, const std::string& cdr) const;

  /// Records the goals as they are now; only if they changed. There must be a session.
  /// @param goals_json  as goals_json() says them
  Problems keep_goals(std::string goals_json);

  bool has_session() const { return session_.has_value(); }
  bool is_watched() const { return session_ && session_->watcher() != nullptr; }
  /// Name of the camera of the cycle's first image; empty: no image was taken.
  const std::string& image_camera() const { return image_camera_; }
  const Vehicle& vehicle() const { return vehicle_; }
  /// True pose at the end of the cycle; null: unknown.
  const Pose2* T_world_vehicle() const {
    return truth_ == nullptr ? nullptr : &truth_->truth().T_world_vehicle;
  }

 private:
  std::optional<SessionRecord>& session_;
  const Vehicle& vehicle_;
  const TruthSource* truth_;
  double stamp_s_ = 0;
  double odometry_m_ = 0;
  std::size_t images_ = 0;
  std::string image_camera_;
  double image_stamp_s_ = 0;
  std::string goals_kept_;
  std::string floor_shown_;
  double floor_shown_s_ = -1;
};

/// Opens the session of a mission: recorded in `out` unless that is empty, and shown to `watcher` if not
/// null; nullopt if neither. The session says whether the vehicle is simulated.
/// @param truth  of the vehicle; null: unknown
Result<std::optional<SessionRecord>> open_session(const std::filesystem::path& out, bool force,
                                                  SessionStorage storage, const Vehicle& vehicle,
                                                  const TruthSource* truth, SessionOrigin origin,
                                                  MessageSink* watcher);

/// The session that shows a replay to `watcher`; nullopt if that is null.
Result<std::optional<SessionRecord>> show_session(const VehicleDescription& vehicle,
                                                  const SessionOrigin& origin, MessageSink* watcher);

/// Closes a session; what was recorded before an interruption stays.
Problems close_session(std::optional<SessionRecord>& session);

}  // namespace aisle
