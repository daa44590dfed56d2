#pragma once
/// Lines of CARMEN logs for tests.

#include <stdexcept>
#include <string>

#include "aisle/formats/logs/carmen_log.hpp"

namespace aisle {

/// Three readings straight right, ahead and left, taken at (1, 2).
inline std::string flaser(double stamp_s, const std::string& ranges = "1.5 2 3") {
  return "FLASER 3 " + ranges + " 1 2 0.5 1 2 0.5 " + std::to_string(stamp_s) + " host 0.1\n";
}

/// A scan of `count` equal readings, taken at (x, 0).
inline std::string flaser_of(std::size_t count, double x_m, double stamp_s) {
  std::string line = "FLASER " + std::to_string(count);
  for (std::size_t i = 0; i < count; ++i) line += " 2";
  const std::string pose = " " + std::to_string(x_m) + " 0 0";
  return line + pose + pose + " " + std::to_string(stamp_s) + " host 0.1\n";
}

inline std::string rawlaser(double stamp_s) {
  return "RAWLASER1 0 -1.0 2.0 1.0 10.0 0.01 0 3 1 2 3 0 " + std::to_string(stamp_s) + " host 0.1\n";
}

inline std::string odom(double x_m, double stamp_s) {
  return "ODOM " + std::to_string(x_m) + " 0 0 0.3 0 0 " + std::to_string(stamp_s) + " host 0.1\n";
}

inline LaserRecording parsed(const std::string& text, const RecordingOptions& options = {}) {
  auto carmen = parse_carmen_log(text, "run.clf", options);
  if (!carmen.ok()) throw std::runtime_error(to_string(carmen.problems()));
  return *carmen;
}

inline std::string warnings_of(const LaserRecording& recording) {
  return to_string(recording.warnings);
}

inline std::string carmen_problems(const std::string& text, const RecordingOptions& options = {}) {
  const auto carmen = parse_carmen_log(text, "run.clf", options);
  return carmen.ok() ? "" : to_string(carmen.problems());
}

}  // namespace aisle
