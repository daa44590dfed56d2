#pragma once
/// The main cycle: sense -> decide -> act. A record receives all observations and decisions.

#include <cstddef>
#include <string>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// Stores a mission's cycles.
class MissionRecord {
 public:
  virtual ~MissionRecord() = default;

  /// Stores an observation.
  /// @return the observation as it will be read back (image compression may be lossy). The navigator gets
  ///         this one, so that a replay sees exactly the same
  virtual Result<Observation> keep(Observation observation) = 0;

  /// Stores the decision on the last observation. Empty on success.
  virtual Problems keep(const Decision& decision) = 0;
};

struct MissionEnd {
  bool arrived = false;
  std::string state;  ///< of the last decision
  std::string why;    ///< of the last decision, or of the vehicle if that ended the mission
  std::size_t cycles = 0;
  double duration_s = 0;  ///< by the observations' stamps
};

/// `MissionEnd::why` of a mission that the user has ended.
inline constexpr const char* kEndedByUser = "ended by the operator";

/// Drives until the navigator is done or has failed, the vehicle delivers no more observations, or the user
/// ends it (`Progress::shall_end`). Always ends with a stop command. A record that fails ends the mission,
/// and its problems are returned. `Interrupted` (from `progress`) is rethrown after the stop.
Result<MissionEnd> run_mission(Vehicle& vehicle, Navigator& navigator, MissionRecord& record,
                               Progress& progress);

}  // namespace aisle
