#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/formats/logs/laser_recording.hpp"
#include "aisle/formats/sessions/session_storage.hpp"

namespace aisle {

struct ImportOptions {
  std::string recording;          ///< what open_image_sequence() or read_laser_recording() reads
  std::filesystem::path out;      ///< directory of the new session
  std::optional<double> rate_hz;  ///< > 0; none: the recording's own stamps
  std::string vehicle;            ///< vehicle file or name of a shipped vehicle; empty: not known
  std::string camera;             ///< topic of a bag's images, else name of the camera; empty: the only one
  RecordingOptions reading;       ///< of scans and odometry
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
};

/// `aisle import INPUT`: makes a session of images and scans that were recorded elsewhere.
Result<Outcome> run_import(const ImportOptions& options, Console& console);

}  // namespace aisle
