#pragma once

#include <string>
#include <vector>

#include "aisle/commands/explore_options.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/commands/simulation_setting.hpp"
#include "aisle/guidance/exploration/explorer_navigator.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/report/exploration_picture.hpp"

namespace aisle {

/// Everything an exploration needs, read and checked.
struct ExplorationPlan {
  SimulationSetting setting;
  ExplorerNavigatorParams params;
  Pose2 T_world_start;
};

/// A finished exploration, judged by the ground truth where that is known.
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

/// A problem if the vehicle cannot explore this world with the sensor that the options name.
Result<ExplorationPlan> read_exploration_plan(const ExploreOptions& options, SimulationSetting setting);

/// Explores, judges the result, and keeps what was learned.
Result<JudgedExploration> explore_and_judge(const ExploreOptions& options, const ExplorationPlan& plan,
                                            Console& console);

/// Lets the robot of options.connection explore, and keeps what was learned. Nobody knows the truth.
Result<JudgedExploration> explore_with_robot(const ExploreOptions& options, Console& console);

/// The picture refers to the exploration, which must outlive it.
ExplorationPicture picture_of(const JudgedExploration& explored);

}  // namespace aisle
