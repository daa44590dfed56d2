#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/logs/laser_recording.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/learning/walls/map_judgement.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vehicle/pose_relation.hpp"

namespace aisle {

enum class MapRules {
  kPublished,  ///< C99's Algorithms 2 and 3 as published
  kRefined,
};

struct MapOptions {
  std::filesystem::path log;
  MapRules rules = MapRules::kRefined;
  RecordingOptions reading;
  std::optional<double> odometry_delay_s;  ///< of the odometry behind its scan; none: estimated from the log
  std::optional<std::filesystem::path> relations;  ///< file of known relative poses, for evaluation
  std::filesystem::path out;                       ///< output directory; empty: figures only
  bool force = false;
  MapMode map_mode = MapMode::kTrinary;  ///< of the map of cells
  bool keeps_floor = true;               ///< the building's file has the floor, too
  bool stages = false;                   ///< add the figures of every stage
  ParameterSources parameters;
};

/// What `aisle map` makes of a recording.
struct RecordingMap {
  std::string name;  ///< of the recording's file, without its endings
  LaserLog log;      ///< as its scans settled it, with the first scanner's mounting as given or found
  MapResult result;
  MapJudgement judgement;
  std::vector<PoseRelation> relations;  ///< that the errors are measured by
  Pose2 T_vehicle_relations;            ///< the point of the vehicle that these are of
  Problems warnings;                    ///< what was guessed, left out or not believed
  double cpu_s = 0;                     ///< processor time of this process until the map was built
  double peak_rss_mb = 0;               ///< likewise its memory
};

/// Maps a recording, in an archive or not, and writes nothing: `out`, `force`, `map_mode` and `keeps_floor`
/// are not used. Warnings are said as they come up.
Result<RecordingMap> map_recording(const MapOptions& options, Console& console);

/// The building that a map is of: its walls, and the floor that was seen.
Building building_of(const RecordingMap& map);

/// "good", "doubtful", "poor" or "unknown".
const char* name_of(Trust trust);
/// Why a map is trusted so far: one sentence without its full stop.
std::string reason_of(const MapJudgement& judgement);

/// `aisle map LOG`: builds the wall map of a building from a recorded laser log.
Result<Outcome> run_map(const MapOptions& options, Console& console);

/// Every parameter of `aisle map` with its default.
Outcome map_parameters();

}  // namespace aisle
