#include "logs/carmen_beam_angles.hpp"

#include <algorithm>
#include <cmath>

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
    case 720:  // full circle
      return 0.5;
    case 682:
    case 683:
    case 769:  // Hokuyo URG
      return 360.0 / 1024;
    case 1080:
    case 1081:  // Hokuyo UTM, 270 deg
    case 1440:  // full circle
      return 0.25;
    default:
      return std::nullopt;
  }
}

/// With an even number, the last beam to the left is missing.
ScanBeams symmetric_beams(std::size_t beams, double step_deg) {
  const std::size_t to_the_right = beams / 2;
  return {-static_cast<double>(to_the_right) * step_deg * kDegree, step_deg * kDegree};
}

/// Over a field of view, one beam at each end of it or, with an even number, none at the last.
ScanBeams beams_over(double field_of_view_deg, std::size_t beams) {
  return symmetric_beams(beams, field_of_view_deg / static_cast<double>(beams - beams % 2));
}

bool is_full_circle(const ScanBeams& beams, std::size_t count) {
  return std::abs(beams.angle_step_rad * static_cast<double>(count) - 2 * kPi) < 1 * kDegree;
}

}  // namespace

ScanBeams flaser_beams(std::size_t beams, std::optional<double> resolution_deg) {
  constexpr double kCircle_deg = 360.5;
  const auto steps = static_cast<double>(beams - 1);
  if (resolution_deg && steps * *resolution_deg > kCircle_deg) resolution_deg.reset();
  std::optional<double> step_deg = resolution_deg;
  if (!step_deg) step_deg = known_step_deg(beams);
  if (!step_deg && beams >= 300 && beams < 540) step_deg = 0.5;
  if (!step_deg) return {-90 * kDegree, 180 * kDegree / steps};
  return symmetric_beams(beams, *step_deg);
}

ScanBeams flaser_beams_like(const ScanBeams& usual, std::size_t usual_count, std::size_t beams,
                            std::optional<double> resolution_deg) {
  const double share = static_cast<double>(beams) / static_cast<double>(usual_count);
  const bool a_few_differ = share > 0.95 && share < 1.05;
  if (!a_few_differ) return flaser_beams(beams, resolution_deg);
  // A turning scanner takes as many readings as its speed allows: they share the circle.
  if (!resolution_deg && is_full_circle(usual, usual_count)) {
    return {usual.first_angle_rad, 2 * kPi / static_cast<double>(beams)};
  }
  return usual;  // the last readings are missing, or there are more
}

std::vector<ScanBeams> other_flaser_beams(std::size_t beams) {
  const ScanBeams circle = beams_over(360, beams);
  const ScanBeams circle_from_ahead = {0, circle.angle_step_rad};
  switch (beams) {
    case 360:
    case 361:
      return {circle, circle_from_ahead};
    case 540:
      return {circle, circle_from_ahead, beams_over(180, beams)};
    case 720:
    case 1440:
      return {circle_from_ahead, beams_over(180, beams), beams_over(270, beams)};
    default:
      if (beams < 200 || known_step_deg(beams)) return {};
      return {circle, circle_from_ahead, beams_over(270, beams), beams_over(180, beams)};
  }
}

LaserScanner flaser_scanner(std::size_t beams) {
  const ScanBeams usual = flaser_beams(beams, std::nullopt);
  LaserScanner laser;
  laser.first_angle_rad = usual.first_angle_rad;
  laser.angle_step_rad = usual.angle_step_rad;
  return laser;
}

}  // namespace aisle
