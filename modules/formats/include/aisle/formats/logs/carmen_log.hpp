#pragma once
/// Laser logs in CARMEN's format, one message per line; see docs/formats/carmen.md.

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
  std::optional<Pose2> T_vehicle_laser;  ///< overrides the laser's mounting in the log
};

struct CarmenLog {
  LaserLog log;
  std::vector<std::string> warnings;  ///< what looks wrong but is usable; one sentence each
};

/// The scans of one scanner in file order, with the odometry. Plain or gzip. Anything unreadable (no scans, a
/// truncated line, a differing number of beams, readings that are not distances ...) is a problem with its
/// line number; after 20 problems the rest is only counted.
Result<CarmenLog> read_carmen_log(const std::filesystem::path& path, const CarmenOptions& options = {});

/// The same from memory; `name` is the file name in problems and warnings.
Result<CarmenLog> parse_carmen_log(std::string_view text, const std::string& name,
                                   const CarmenOptions& options = {});

/// The scanner that writes FLASER lines with this many readings. A FLASER line contains no angles; they
/// follow from the number of readings, as docs/formats/carmen.md explains.
/// @param beams  2 or more
LaserScanner flaser_scanner(std::size_t beams);

/// The log as PARAM and FLASER lines; reading them gives the same log.
/// @throws std::invalid_argument if FLASER lines cannot express it: every scan needs its own odometry sample
///         (same index, same time), all scans the same number of readings, and the beam angles must be those
///         of flaser_scanner().
std::string carmen_text(const LaserLog& log);

}  // namespace aisle
