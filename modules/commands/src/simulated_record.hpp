#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "aisle/control/path.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "viewer_messages.hpp"

namespace aisle {

/// Records a simulated mission and its ground truth in a session, if there is one.
class SimulatedRecord : public MissionRecord {
 public:
  SimulatedRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle)
      : session_(session), vehicle_(vehicle) {}

  Result<Observation> keep(Observation observation) override;
  Problems keep(const Decision& decision) override;

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

  bool is_watched() const { return session_ && session_->watcher() != nullptr; }
  /// Name of the camera of the cycle's first image; empty: no image was taken.
  const std::string& image_camera() const { return image_camera_; }

 private:
  std::optional<SessionRecord>& session_;
  const SimulatedVehicle& vehicle_;
  std::size_t images_ = 0;
  std::string image_camera_;
  double image_stamp_s_ = 0;
  std::string floor_shown_;
  double floor_shown_s_ = -1;
};

/// Opens the session of a mission: recorded in `out` unless that is empty, and shown to `watcher` if not
/// null; nullopt if neither.
Result<std::optional<SessionRecord>> open_session(const std::filesystem::path& out, bool force,
                                                  const VehicleDescription& vehicle,
                                                  const SessionOrigin& origin, MessageSink* watcher);

/// Closes a session; what was recorded before an interruption stays.
Problems close(std::optional<SessionRecord>& session);

}  // namespace aisle
