#include "logs/carmen_beam_angles.hpp"

#include "aisle/core/angle.hpp"
#include "aisle/formats/logs/carmen_log.hpp"

namespace aisle {
namespace {

/// The angle step of scanners that are recognised by their number of readings.
std::optional<double> known_step_deg(std::size_t beams) {
  switch (beams) {
    case 180:
    case 181:  // SICK LMS, 180 deg
      return 1;
    case 360:
    case 361:  // SICK LMS, 180 deg
    case 540:
    case 541:  // 270 deg
      return 0.5;
    case 682:
    case 683:
    case 769:  // Hokuyo URG
      return 360.0 / 1024;
    case 1080:
    case 1081:  // Hokuyo UTM, 270 deg
      return 0.25;
    default:
      return std::nullopt;
  }
}

}  // namespace

BeamAngles flaser_beam_angles(std::size_t beams, std::optional<double> resolution_deg) {
  std::optional<double> step_deg = known_step_deg(beams);
  if (!step_deg) step_deg = resolution_deg;
  if (!step_deg && beams >= 300 && beams < 540) step_deg = 0.5;
  if (!step_deg) return {-90 * kDegree, 180 * kDegree / static_cast<double>(beams - 1)};
  const std::size_t ahead = beams / 2;  // with an even number, the last beam to the left is missing
  return {-static_cast<double>(ahead) * *step_deg * kDegree, *step_deg * kDegree};
}

LaserScanner flaser_scanner(std::size_t beams) {
  const BeamAngles angles = flaser_beam_angles(beams, std::nullopt);
  LaserScanner laser;
  laser.first_angle_rad = angles.first_angle_rad;
  laser.angle_step_rad = angles.angle_step_rad;
  return laser;
}

}  // namespace aisle
