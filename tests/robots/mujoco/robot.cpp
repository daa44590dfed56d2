#include "robot.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "model.hpp"

namespace robots {
namespace {

constexpr double kGrip = 1, kLittleGrip = 0.15;

std::string model_for(const Options& options, const World& world, const Vehicle& vehicle) {
  ModelSettings settings{.wheel_friction = options.slip ? kLittleGrip : kGrip};
  for (const ImageSize& size : {options.camera.value_or(ImageSize{}), Robot::kPictureSize}) {
    settings.image_width_px = std::max(settings.image_width_px, size.width_px);
    settings.image_height_px = std::max(settings.image_height_px, size.height_px);
  }
  return model_of(world, vehicle, options.T_world_start.value_or(world.T_world_start), settings);
}

/// As well as wheels are known: to half a percent in size and separation, and two in ten thousand in whether
/// both are equal.
Calibration calibration_with_errors(const Vehicle& vehicle, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> scale{1, 0.005}, difference{0, 0.0002};
  const double radius_m = vehicle.wheel_radius_m * scale(random);
  const double unequal = difference(random);
  return {radius_m * (1 - unequal), radius_m * (1 + unequal), vehicle.wheel_separation_m * scale(random)};
}

}  // namespace

Robot::Robot(const Options& options, const World& world, const Vehicle& vehicle)
    : options_(options),
      physics_(model_for(options, world, vehicle)),
      calibration_(calibration_with_errors(vehicle, options.seed)),
      driver_(vehicle, calibration_),
      odometry_(calibration_),
      scanner_(options.scan_beams, options.range_max_m, options.seed),
      record_(physics_.T_world_vehicle()),
      participant_(options.domain),
      commands_(participant_, options.ros_namespace + "/cmd_vel", options.command),
      telemetry_(participant_, options, vehicle),
      scan_beat_{1 / options.scan_hz} {
  if (options.camera || !options.picture.empty()) view_.emplace(physics_);
}

void Robot::introduce(const Time& now) const {
  telemetry_.publish_mounts(now);
}

void Robot::cycle(const Time& begin, const Time& end) {
  while (const auto command = commands_.take(time_s(), begin)) {
    driver_.take(*command);
    record_.note_command(time_s());
  }
  const bool command_is_fresh = driver_.is_fresh(time_s());
  physics_.drive(driver_.targets(time_s(), kCycle_s));
  physics_.advance(kCycle_s);
  odometry_.advance(physics_.joint("left_wheel"), physics_.joint("right_wheel"));
  record_.note({time_s(), kCycle_s, physics_.T_world_vehicle(), driver_.speed_mps(), command_is_fresh,
                physics_.hull_touches()});
  publish(end);
}

void Robot::publish(const Time& stamp) {
  telemetry_.publish_clock(stamp);
  if (odometry_beat_.is_due(time_s())) {
    telemetry_.publish_odometry(stamp, odometry_);
    telemetry_.publish_joints(stamp, physics_);
    telemetry_.publish_bumper(physics_.hull_touches());
  }
  if (scan_beat_.is_due(time_s())) {
    telemetry_.publish_scan(stamp, scanner_, scanner_.scan(physics_), scan_beat_.period_s);
  }
  if (options_.camera && image_beat_.is_due(time_s())) {
    telemetry_.publish_image(stamp, view_->draw(physics_, "front", *options_.camera));
  }
}

std::vector<std::uint8_t> Robot::seen_from_above() {
  return view_->draw(physics_, "top", kPictureSize);
}

nlohmann::json Robot::report() const {
  nlohmann::json report = record_.report();
  report["simulated"] = true;
  report["seed"] = options_.seed;
  report["simulated_s"] = time_s();
  report["odometry_end"] = to_json(odometry_.T_odom_vehicle());
  return report;
}

bool Robot::Beat::is_due(double time_s) {
  constexpr double kRounding_s = 1e-6;
  if (time_s < next_s - kRounding_s) return false;
  next_s += period_s;
  return true;
}

}  // namespace robots
