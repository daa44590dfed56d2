#pragma once

#include <filesystem>
#include <optional>

#include "aisle/control/path.hpp"
#include "aisle/formats/session_record.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"

namespace aisle {

/// Keeps a simulated mission as a session, the truth beside it; without a session nothing.
class SimulatedRecord : public MissionRecord {
 public:
  SimulatedRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle)
      : session_(session), vehicle_(vehicle) {}

  Result<Observation> keep(Observation observation) override;
  Problems keep(const Decision& decision) override;

  std::size_t pictures() const { return pictures_; }

 protected:
  /// Shows whoever watches where the navigator takes the vehicle to be, and along what it drives; nothing of
  /// it is kept.
  void show_pose(const UncertainPose2& T_map_vehicle) const;
  void show_plan(const Path& path) const;

 private:
  std::optional<SessionRecord>& session_;
  const SimulatedVehicle& vehicle_;
  std::size_t pictures_ = 0;
};

/// The session of a mission: kept in `out` unless that is empty, shown to whoever watches; nullopt: neither.
Result<std::optional<SessionRecord>> open_session(const std::filesystem::path& out, bool force,
                                                  const VehicleDescription& vehicle,
                                                  const SessionOrigin& origin, MessageSink* watcher);

/// Ends a session; what was driven before an interruption stays.
Problems close(std::optional<SessionRecord>& session);

}  // namespace aisle
