#pragma once

#include <string>
#include <vector>

#include "aisle/commands/explore.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/report/exploration_picture.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// An exploration that was driven and judged by the truth.
struct JudgedExploration {
  Outcome outcome;
  Building building;  ///< as it was learned, with its floor
  ExplorationRecord record;
  std::vector<Pose2> T_map_vehicle;  ///< the path, in the learned map
  LaserLog scans;                    ///< what was seen on it, one a pose
  SegmentParams segments;            ///< how walls were found in them
};

/// The vehicle that explores: as asked, else the shipped one with the sensor.
std::string exploring_vehicle(const ExploreOptions& options);

/// `aisle explore` in a setting that was read, or made by chance.
Result<Outcome> explore_in(const ExploreOptions& options, SimulationSetting setting, Console& console);

/// The same without files.
Result<JudgedExploration> explore_and_judge(const ExploreOptions& options, SimulationSetting setting,
                                            Console& console);

/// Refers to the exploration, which must outlive it.
ExplorationPicture image_of(const JudgedExploration& explored);

}  // namespace aisle
