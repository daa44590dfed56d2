#pragma once
/// Relative poses between scans of one log, made by others to measure trajectories with.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

struct PoseRelation {
  std::size_t scan_1 = 0;  ///< index into LaserLog::scans
  std::size_t scan_2 = 0;
  Pose2 T_1_2;  ///< the vehicle at scan_2, seen from the vehicle at scan_1
};

/// Lines `t1 t2 x y z roll pitch yaw` (recorded stamps, matched within 1 ms) or `i1 i2 x y yaw` (0-based
/// numbers of scans); plain or gzip. Relations that name no scan of the log are problems that name the line.
Result<std::vector<PoseRelation>> read_relations(const std::filesystem::path& path, const LaserLog& log);

/// The same from memory; `name` stands for the file in problems.
Result<std::vector<PoseRelation>> parse_relations(std::string_view text, const std::string& name,
                                                  const LaserLog& log);

}  // namespace aisle
