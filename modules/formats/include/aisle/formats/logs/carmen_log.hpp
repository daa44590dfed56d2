#pragma once
/// Laser logs as CARMEN writes them: one message a line. docs/formats/carmen.md says what is read and how.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

enum class LengthUnit { kMetre, kCentimetre };

struct CarmenOptions {
  LengthUnit unit = LengthUnit::kMetre;  ///< of every length in the file
  std::optional<Pose2> T_vehicle_laser;  ///< overrides what the log says about the laser's mounting
};

struct CarmenLog {
  LaserLog log;
  std::vector<std::string> warnings;  ///< what looks wrong but could be dealt with; one sentence each
};

/// The scans of one scanner in the order of the file, with the odometry. Plain or gzip.
/// Anything unreadable (no scans, a line cut off, a differing number of beams, readings that are no distances
/// ...) is a problem that names the line; after 20 problems the rest is only counted.
Result<CarmenLog> read_carmen_log(const std::filesystem::path& path, const CarmenOptions& options = {});

/// The same from memory; `name` stands for the file in problems and warnings.
Result<CarmenLog> parse_carmen_log(std::string_view text, const std::string& name,
                                   const CarmenOptions& options = {});

/// The scanner of which a FLASER line with this many readings speaks. A FLASER line gives no angles: they
/// follow from the number of readings as docs/formats/carmen.md tells.
/// @param beams  2 or more
LaserScanner flaser_scanner(std::size_t beams);

/// The log as PARAM and FLASER lines; reading them gives the same log.
/// What a FLASER line cannot express throws std::invalid_argument: every scan needs an odometry sample of its
/// own (the same index, the same time) and as many readings as the others, the beams must lie as in
/// flaser_scanner().
std::string carmen_text(const LaserLog& log);

}  // namespace aisle
