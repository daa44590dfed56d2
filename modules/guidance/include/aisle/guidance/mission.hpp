#pragma once
/// The one cycle: sense -> decide -> act, with everything that flowed handed to a record.

#include <cstddef>
#include <string>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// Where a mission's cycles are kept.
class MissionRecord {
 public:
  virtual ~MissionRecord() = default;

  /// Keeps an observation.
  /// @return the observation as the record will give it back (images may lose by their compression): the
  ///         navigator sees that one, so that a replay sees exactly the same
  virtual Result<Observation> keep(Observation observation) = 0;

  /// Keeps what was decided on the observation before. Empty on success.
  virtual Problems keep(const Decision& decision) = 0;
};

struct MissionEnd {
  bool arrived = false;
  std::string state;  ///< of the last decision
  std::string why;
  std::size_t cycles = 0;
  double duration_s = 0;  ///< by the observations' stamps
};

/// Drives until the navigator is done or has failed, or the vehicle senses nothing any more. Whatever ends
/// it, the vehicle is given to stop; a record that fails ends the mission, and its problems are returned.
/// `Interrupted` (from `progress`) is passed on after the stop.
Result<MissionEnd> run_mission(Vehicle& vehicle, Navigator& navigator, MissionRecord& record,
                               Progress& progress);

}  // namespace aisle
