#pragma once

#include <string>
#include <vector>

#include "aisle/commands/explore.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/report/exploration_picture.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// A finished exploration, judged by the ground truth.
struct JudgedExploration {
  Outcome outcome;
  Building building;  ///< as learned, with its floor
  ExplorationRecord record;
  std::vector<Pose2> T_map_vehicle;  ///< the path, in the learned map
  LaserLog scans;                    ///< one scan per pose of the path
  SegmentParams segments;            ///< how walls were found in the scans
};

/// The vehicle that explores: the requested one, else the shipped one with the sensor.
std::string exploring_vehicle(const ExploreOptions& options);

/// `aisle explore` in a given setting, read or random.
Result<Outcome> explore_in(const ExploreOptions& options, SimulationSetting setting, Console& console);

/// The same without files.
Result<JudgedExploration> explore_and_judge(const ExploreOptions& options, SimulationSetting setting,
                                            Console& console);

/// The picture refers to the exploration, which must outlive it.
ExplorationPicture picture_of(const JudgedExploration& explored);

}  // namespace aisle
