#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/trajectory.hpp"

namespace aisle {

/// Where the vehicle of a simulated session really was, a pose a cycle, in the world's frame: for evaluation
/// alone. Empty if the session does not say.
Result<Trajectory> read_true_poses(const std::filesystem::path& session);

}  // namespace aisle
