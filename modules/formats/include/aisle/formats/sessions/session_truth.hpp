#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/trajectory.hpp"

namespace aisle {

/// The true poses of a simulated session's vehicle, one per cycle, in the world's frame: for evaluation only.
/// Empty if the session has none.
Result<Trajectory> read_true_poses(const std::filesystem::path& session);

}  // namespace aisle
