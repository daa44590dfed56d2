#pragma once

#include <optional>

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

 private:
  std::optional<SessionRecord>& session_;
  const SimulatedVehicle& vehicle_;
  std::size_t pictures_ = 0;
};

/// Ends a session; what was driven before an interruption stays.
Problems close(std::optional<SessionRecord>& session);

}  // namespace aisle
