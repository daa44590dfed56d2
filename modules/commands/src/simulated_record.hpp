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

/// Keeps a simulated mission as a session, the truth beside it; without a session nothing.
class SimulatedRecord : public MissionRecord {
 public:
  SimulatedRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle)
      : session_(session), vehicle_(vehicle) {}

  Result<Observation> keep(Observation observation) override;
  Problems keep(const Decision& decision) override;

  std::size_t images() const { return images_; }

 protected:
  /// To whoever watches; nothing of it is kept. Where the navigator takes the vehicle to be, along what it
  /// drives, how well what it sees fits what it knows, and what it saw in the cycle's first image.
  void show_pose(const UncertainPose2& T_map_vehicle) const;
  void show_plan(const Path& path) const;
  void show_match(const ViewMatch& match) const;
  void show_overlay(const Overlay& overlay) const;
  /// The floor as it is known now: at most every two seconds, and only what is new.
  void show_floor(const FloorGrid& floor);
  void show(const SessionTopic& topic, const std::string& cdr) const;

  bool is_watched() const { return session_ && session_->watcher() != nullptr; }
  /// The camera of the cycle's first image; empty: none was taken.
  const std::string& pictured_by() const { return image_camera_; }

 private:
  std::optional<SessionRecord>& session_;
  const SimulatedVehicle& vehicle_;
  std::size_t images_ = 0;
  std::string image_camera_;
  double image_stamp_s_ = 0;
  std::string floor_shown_;
  double floor_shown_s_ = -1;
};

/// The session of a mission: kept in `out` unless that is empty, shown to whoever watches; nullopt: neither.
Result<std::optional<SessionRecord>> open_session(const std::filesystem::path& out, bool force,
                                                  const VehicleDescription& vehicle,
                                                  const SessionOrigin& origin, MessageSink* watcher);

/// Ends a session; what was driven before an interruption stays.
Problems close(std::optional<SessionRecord>& session);

}  // namespace aisle
