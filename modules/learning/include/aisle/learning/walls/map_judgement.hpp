#pragma once

#include <span>

#include "aisle/maps/wall_map.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// How well a map explains the scans that it was made of, by readings sampled over the whole path.
struct MapJudgement {
  double fit_share = 0;   ///< of the readings that end within 10 cm of a wall
  double pass_share = 0;  ///< of those that would have to pass through a wall by more than 30 cm
  std::size_t readings = 0;
};

/// Unknown where there are too few readings to judge by.
enum class Trust { kGood, kDoubtful, kPoor, kUnknown };

/// How far the map can be trusted. In a map that is torn or drawn twice, beams pass through walls.
Trust trust_in(const MapJudgement& judgement);

/// @param T_map_vehicle  one per scan
MapJudgement judge_map(const WallMap& walls, const LaserLog& log, std::span<const Pose2> T_map_vehicle);

}  // namespace aisle
