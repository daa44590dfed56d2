#pragma once
/// What every learning method takes from a recorded session.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// An imported session may lack what maps are made with: odometry, the camera's calibration. Empty: it has
/// both.
Problems check_for_learning(const std::filesystem::path& session, const SessionOrigin& origin);

/// The route that the session names; "route" if it names none.
Result<std::string> route_of_session(const std::filesystem::path& session, const SessionOrigin& origin);

/// Passes the observations of a session that was just opened to `take`, in order. A session without cycles,
/// odometry or the camera's calibration is a problem.
/// @return number of images
Result<std::size_t> take_observations(const std::filesystem::path& session, SessionCycles& cycles,
                                      Progress& progress,
                                      const std::function<void(const Observation&)>& take);

/// True poses of a simulated session, one per cycle: for evaluation only.
/// @return empty if the session does not have them for all cycles
Result<std::vector<Pose2>> true_poses(const std::filesystem::path& session, std::size_t cycles);

}  // namespace aisle
