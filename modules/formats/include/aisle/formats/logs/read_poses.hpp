#pragma once

#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/trajectory.hpp"

namespace aisle {

/// The poses of a file, whatever measured them: TUM, a table (CSV) with the columns time_s, x_m, y_m and
/// heading_deg of docs/formats/laser_csv.md, each plain or gzip, or a topic of poses or odometry of a bag,
/// with the stamps of its headers. In the order of the stamps; of equal stamps, the first.
/// @param topic  of a bag; empty: the only one. Several are a problem that names them
Result<Trajectory> read_poses(const std::filesystem::path& path, const std::string& topic = {});

/// The table from memory; `name` is the file name in problems.
Result<Trajectory> parse_pose_csv(std::string_view text, const std::string& name);

}  // namespace aisle
