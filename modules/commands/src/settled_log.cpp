#include "settled_log.hpp"

#include <utility>

#include "aisle/formats/logs/read_laser_recording.hpp"
#include "aisle/learning/walls/log_correction.hpp"

namespace aisle {

Result<SettledLog> read_settled_log(const std::filesystem::path& file, const RecordingOptions& reading,
                                    Progress& progress) {
  auto read = read_laser_recording(file, reading);
  if (!read) return read.problems();
  SettledLog settled{std::move(read->log), std::move(read->warnings), {}};
  settled.known.mounting = read->has_mounting || reading.T_vehicle_laser.has_value();
  auto findings = correct_log(settled.log, {!settled.known.mounting, read->other_beams}, progress);
  if (!findings) return at_file(findings.problems(), file.string());
  for (Problem& warning : at_file(findings->warnings, file.string()))
    settled.warnings.push_back(std::move(warning));
  settled.known.guessed_delay_s = findings->odometry_delay_s;
  if (findings->odometry_by_scans) settled.known = {.odometry_delay_s = 0.0};
  return settled;
}

Result<SettledLog> read_unsettled_log(const std::filesystem::path& file, const RecordingOptions& reading) {
  auto read = read_laser_recording(file, reading);
  if (!read) return read.problems();
  if (read->log.odometry.empty())
    return Problem{{file.string()}, "has no odometry; the published rules cannot do without"};
  return SettledLog{std::move(read->log), std::move(read->warnings), {}};
}

}  // namespace aisle
