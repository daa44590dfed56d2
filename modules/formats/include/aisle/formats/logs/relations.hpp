#pragma once
/// Reference relative poses between scans of a log, published by others to evaluate trajectories.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vehicle/pose_relation.hpp"

namespace aisle {

/// Lines `t1 t2 x y z roll pitch yaw` (recorded stamps, matched within 1 ms) or `i1 i2 x y yaw` (0-based scan
/// numbers); plain or gzip. A relation with a scan that the log does not have is a problem with its line
/// number.
Result<std::vector<PoseRelation>> read_relations(const std::filesystem::path& path, const LaserLog& log);

/// The same from memory; `name` is the file name in problems.
Result<std::vector<PoseRelation>> parse_relations(std::string_view text, const std::string& name,
                                                  const LaserLog& log);

}  // namespace aisle
