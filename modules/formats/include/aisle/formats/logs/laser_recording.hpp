#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// What a recording says of a 2-D scanner and its vehicle, whatever its format.
struct LaserRecording {
  LaserLog log;
  Problems warnings;  ///< what was guessed or left out: where, and one sentence
  /// Beams that the scans may have instead, where the recording does not give their angles.
  std::vector<ScanBeams> other_beams = {};
  bool has_mounting = false;  ///< the recording or the user gives the scanner's mounting
};

enum class LengthUnit { kMetre, kCentimetre, kMillimetre };

/// What the user says of a recording; what is not said is found in it, or guessed with a warning.
struct RecordingOptions {
  LengthUnit unit = LengthUnit::kMetre;  ///< of every length in a text
  std::optional<Pose2> T_vehicle_laser;  ///< overrides the recording's
  std::string scan_topic = {};           ///< of a bag; empty: chosen
  std::string odometry = {};             ///< of a bag: a topic, "tf" or "none"; empty: chosen
};

}  // namespace aisle
