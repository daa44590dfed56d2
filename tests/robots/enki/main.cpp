/// A marXbot as Enki ships it, in a world of aisle's format: it speaks ROS 2 and knows nothing of aisle.
/// Drive, noise, size and the turning scanner are Enki's; the scanner's range is ours. See ../README.md.

#include <enki/PhysicalEngine.h>
#include <enki/robots/marxbot/Marxbot.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "mujoco/pace.hpp"
#include "mujoco/pose.hpp"
#include "mujoco/world.hpp"
#include "ros/messages.hpp"
#include "ros/participant.hpp"

namespace robots {
namespace {

constexpr double kCm = 100;  // Enki's unit is the centimetre
constexpr double kCycle_s = 0.02;
constexpr int kCyclesOfScan = 5;
constexpr double kRange_m = 8;
constexpr double kCommandAgeMax_s = 0.5;

volatile std::sig_atomic_t interrupted = 0;

/// Gives what Enki keeps to itself.
class Marxbot final : public Enki::Marxbot {
 public:
  double separation_m() const { return distBetweenWheels / kCm; }
  double speed_max_mps() const { return maxSpeed / kCm; }
};

/// Enki's obstacles are convex bodies that do not move.
void build(Enki::World& enki, const World& world) {
  for (const Solid& solid : world.solids) {
    if (!solid.is_obstacle) continue;
    auto* body = new Enki::PhysicalObject;  // Enki's world deletes it
    constexpr double kImmovable = -1;
    if (solid.shape == Solid::Shape::kBox)
      body->setRectangular(kCm * solid.length_m, kCm * solid.width_m, kCm * solid.top_m, kImmovable);
    else
      body->setCylindric(kCm * solid.length_m / 2, kCm * solid.top_m, kImmovable);
    body->pos = {kCm * solid.T_world_centre.x, kCm * solid.T_world_centre.y};
    body->angle = solid.T_world_centre.heading_rad;
    enki.addObject(body);
  }
}

class Robot {
 public:
  Robot(const World& world, unsigned domain) : participant_(domain) {
    build(enki_, world);
    marxbot_->pos = {kCm * world.T_world_start.x, kCm * world.T_world_start.y};
    marxbot_->angle = world.T_world_start.heading_rad;
    marxbot_->rotatingDistanceSensor.setRange(kCm * kRange_m);
    enki_.addObject(marxbot_);
    T_world_start_ = T_world_vehicle();
    mounts_.publish({{{{{}, "base_link"}, "laser", {}, {}}}});
  }

  void cycle(const Time& begin, const Time& end) {
    obey(begin.seconds());
    enki_.step(kCycle_s);
    count_wheels();
    clock_.publish({end});
    publish_odometry(end);
    if (++cycles_ % kCyclesOfScan == 0) publish_scan(end);
  }

  double time_s() const { return kCycle_s * static_cast<double>(cycles_); }
  double radius_m() const { return marxbot_->getRadius() / kCm; }

  nlohmann::json report() const {
    const Pose2 T_world_end = T_world_vehicle();
    return {{"off_home_m", std::hypot(T_world_end.x - T_world_start_.x, T_world_end.y - T_world_start_.y)},
            {"path_m", path_m_}};
  }

 private:
  Pose2 T_world_vehicle() const { return {marxbot_->pos.x / kCm, marxbot_->pos.y / kCm, marxbot_->angle}; }

  /// For half a second after the last command.
  void obey(double now_s) {
    while (const auto command = commands_.take()) {
      command_ = *command;
      commanded_s_ = now_s;
    }
    if (now_s - commanded_s_ > kCommandAgeMax_s) command_ = {};
    const double turn_mps = command_.angular.z * marxbot_->separation_m() / 2;
    marxbot_->leftSpeed = kCm * (command_.linear.x - turn_mps);
    marxbot_->rightSpeed = kCm * (command_.linear.x + turn_mps);
  }

  void count_wheels() {
    const double left_m = (marxbot_->leftOdometry - left_cm_) / kCm;
    const double right_m = (marxbot_->rightOdometry - right_cm_) / kCm;
    left_cm_ = marxbot_->leftOdometry;
    right_cm_ = marxbot_->rightOdometry;
    const Pose2 half_turn{0, 0, (right_m - left_m) / marxbot_->separation_m() / 2};
    T_odom_vehicle_ = T_odom_vehicle_ * half_turn * Pose2{(left_m + right_m) / 2, 0, 0} * half_turn;
    path_m_ += std::abs(left_m + right_m) / 2;
  }

  void publish_odometry(const Time& stamp) const {
    Odometry message;
    message.header = {stamp, "odom"};
    message.child_frame_id = "base_link";
    message.pose.position = {T_odom_vehicle_.x, T_odom_vehicle_.y, 0};
    message.pose.orientation = {0, 0, std::sin(T_odom_vehicle_.heading_rad / 2),
                                std::cos(T_odom_vehicle_.heading_rad / 2)};
    odometry_.publish(message);
  }

  void publish_scan(const Time& stamp) const {
    const auto& squared_cm2 = marxbot_->rotatingDistanceSensor.zbuffer;
    LaserScan message;
    message.header = {stamp, "laser"};
    const double step_rad = 2 * std::numbers::pi / static_cast<double>(squared_cm2.size());
    message.angle_min = static_cast<float>(-std::numbers::pi + step_rad / 2);
    message.angle_increment = static_cast<float>(step_rad);
    message.angle_max = static_cast<float>(std::numbers::pi - step_rad / 2);
    message.range_max = static_cast<float>(kRange_m);
    for (const double distance_cm2 : squared_cm2) {
      const double range_m = std::sqrt(distance_cm2) / kCm;
      message.ranges.push_back(range_m < kRange_m ? static_cast<float>(range_m)
                                                  : std::numeric_limits<float>::infinity());
    }
    scan_.publish(message);
  }

  Enki::World enki_;
  Marxbot* marxbot_ = new Marxbot;  // the world deletes it
  Participant participant_;
  Publisher<TFMessage> mounts_{participant_, "/tf_static", Quality::kLatched};
  Publisher<Clock> clock_{participant_, "/clock", Quality::kSensor};
  Publisher<Odometry> odometry_{participant_, "/odom", Quality::kDefault};
  Publisher<LaserScan> scan_{participant_, "/scan", Quality::kSensor};
  Subscription<Twist> commands_{participant_, "/cmd_vel", Quality::kDefault};
  Twist command_;
  double commanded_s_ = -kCommandAgeMax_s;
  double left_cm_ = 0, right_cm_ = 0, path_m_ = 0;
  Pose2 T_world_start_, T_odom_vehicle_;
  long cycles_ = 0;
};

void run(std::map<std::string, std::string>& options) {
  Robot robot(read_world(options.at("--world")), static_cast<unsigned>(std::stoul(options.at("--domain"))));
  std::cout << nlohmann::json{{"vehicle", {{"radius_m", robot.radius_m()}}}} << std::endl;
  Pace pace(std::stod(options.at("--speed")), true);
  while (interrupted == 0) {
    const double begin_s = robot.time_s(), end_s = begin_s + kCycle_s;
    pace.wait_for(end_s);
    robot.cycle(pace.stamp(begin_s), pace.stamp(end_s));
  }
  std::ofstream(options.at("--report")) << robot.report() << '\n';
}

}  // namespace
}  // namespace robots

/// usage: enki_robot --world FILE --domain N --speed F --report FILE      until SIGTERM
int main(int argc, char** argv) {
  std::signal(SIGTERM, [](int) { robots::interrupted = 1; });
  try {
    std::map<std::string, std::string> options;
    for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
    robots::run(options);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "enki_robot: " << error.what() << std::endl;
    return 1;
  }
}
