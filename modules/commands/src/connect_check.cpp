#include "connect_check.hpp"

#include <fmt/format.h>

#include "aisle/commands/connected_robot.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/missions/mission_result.hpp"
#include "aisle/vehicle/floor_in_image.hpp"

namespace aisle {
namespace {

nlohmann::ordered_json pace_json(const TopicPace& pace) {
  return {{"messages", pace.messages},
          {"rate_hz", rounded(pace.rate_hz(), 2)},
          {"gap_max_s", rounded(pace.gap_max_s, 3)},
          {"age_s", rounded(pace.age_mean_s(), 4)},
          {"age_max_s", rounded(pace.age_max_s, 4)}};
}

/// What a camera could serve for: every method that drives by one needs the floor in view.
std::string serves_for(const CameraDescription& camera) {
  return FloorInImage(camera).nearest_m() > 0 ? "teach, learn, navigate, park"
                                              : "drive alone: no floor in view";
}

nlohmann::ordered_json scanner_json(const RobotCheck& check) {
  if (!check.vehicle.scanner) return {};
  const LaserScanner& scanner = *check.vehicle.scanner;
  return {{"beams", check.beams},
          {"first_angle_deg", rounded(to_degrees(scanner.first_angle_rad), 3)},
          {"angle_step_deg", rounded(to_degrees(scanner.angle_step_rad), 4)},
          {"range_max_m", rounded(scanner.range_max_m, 3)},
          {"x_m", rounded(scanner.T_vehicle_laser.x, 3)},
          {"y_m", rounded(scanner.T_vehicle_laser.y, 3)},
          {"heading_deg", rounded(to_degrees(scanner.T_vehicle_laser.theta), 2)},
          {"upside_down", check.is_upside_down}};
}

nlohmann::ordered_json cameras_json(const RobotCheck& check) {
  auto list = nlohmann::ordered_json::array();
  for (const SeenCamera& seen : check.cameras) {
    const CameraDescription& camera = seen.camera;
    const Vec3& p_vehicle_camera = camera.mount.p_vehicle_camera;
    list.push_back({{"name", camera.name},
                    {"images", seen.images},
                    {"width_px", camera.width_px},
                    {"height_px", camera.height_px},
                    {"fx_px", rounded(camera.intrinsics.fx_px, 2)},
                    {"lens_from", seen.lens_from},
                    {"mount_from", seen.mount_from},
                    {"x_m", rounded(p_vehicle_camera.x(), 3)},
                    {"y_m", rounded(p_vehicle_camera.y(), 3)},
                    {"z_m", rounded(p_vehicle_camera.z(), 3)},
                    {"tilt_deg", rounded(to_degrees(camera.mount.tilt_rad), 2)},
                    {"pan_deg", rounded(to_degrees(camera.mount.pan_rad), 2)},
                    {"pace", pace_json(seen.pace)},
                    {"could_serve_for", serves_for(camera)}});
  }
  return list;
}

std::string pace_text(const char* name, const TopicPace& pace) {
  return fmt::format("  {:<10} {:5.1f} a second, longest gap {:.2f} s, {:.3f} s old on arrival\n", name,
                     pace.rate_hz(), pace.gap_max_s, pace.age_mean_s());
}

std::string scanner_text(const RobotCheck& check) {
  if (!check.vehicle.scanner) return {};
  const LaserScanner& scanner = *check.vehicle.scanner;
  return pace_text("scans", check.scan) +
         fmt::format(
             "  scanner    {} beams from {:.1f} in steps of {:.3f} deg, up to {:.1f} m, at x {:.3f} m, "
             "y {:.3f} m, {:.1f} deg{}: explore, go, patrol\n",
             check.beams, to_degrees(scanner.first_angle_rad), to_degrees(scanner.angle_step_rad),
             scanner.range_max_m, scanner.T_vehicle_laser.x, scanner.T_vehicle_laser.y,
             to_degrees(scanner.T_vehicle_laser.theta), check.is_upside_down ? ", upside down" : "");
}

std::string camera_text(const SeenCamera& seen) {
  const CameraDescription& camera = seen.camera;
  const Vec3& p_vehicle_camera = camera.mount.p_vehicle_camera;
  return pace_text("images", seen.pace) +
         fmt::format(
             "  camera     '{}', {} x {} pixels, focal length {:.1f} px by {}; at x {:.3f} m, y {:.3f} m, "
             "{:.3f} m high, {:.1f} deg down by {}: {}\n",
             camera.name, camera.width_px, camera.height_px, camera.intrinsics.fx_px, seen.lens_from,
             p_vehicle_camera.x(), p_vehicle_camera.y(), p_vehicle_camera.z(),
             to_degrees(camera.mount.tilt_rad), seen.mount_from, serves_for(camera));
}

}  // namespace

nlohmann::ordered_json figures_of(const RobotCheck& check) {
  const bool has_scanner = check.vehicle.scanner.has_value();
  return known_figures({{"scan", has_scanner ? pace_json(check.scan) : nlohmann::ordered_json()},
                        {"odometry", pace_json(check.odometry)},
                        {"scanner", scanner_json(check)},
                        {"cameras", cameras_json(check)},
                        {"command_type", check.command_type},
                        {"counts", counts_json(check.counts)}});
}

std::string check_text(const RobotCheck& check) {
  std::string text = check.command_type.empty()
                         ? "the robot can be listened to; the connection has no topic of commands\n"
                         : "the robot can be driven; nothing was commanded\n";
  text += scanner_text(check);
  for (const SeenCamera& seen : check.cameras) text += camera_text(seen);
  text += pace_text("odometry", check.odometry);
  if (check.command_type.empty()) return text;
  return text + fmt::format(
                    "  commands   {}\n  Whether it stops by itself when commands end is found out by 'aisle "
                    "connect try'.\n",
                    check.command_type);
}

}  // namespace aisle
