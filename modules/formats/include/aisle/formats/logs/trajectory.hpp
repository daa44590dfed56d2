#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Time-stamped poses of a vehicle. Both lists have the same length.
struct Trajectory {
  std::vector<double> stamps_s;
  std::vector<Pose2> T_map_vehicle;
};

/// TUM format: one `stamp x y z qx qy qz qw` per line, rounded to microseconds, micrometres and, in the
/// quaternion, 1e-9.
std::string tum_text(std::span<const double> stamps_s, std::span<const Pose2> T_map_vehicle);

/// The trajectory in the x-y plane: z is dropped, the heading is the quaternion's yaw. Plain or gzip.
Result<Trajectory> read_tum(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<Trajectory> parse_tum(std::string_view text, const std::string& name);

}  // namespace aisle
