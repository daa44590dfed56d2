/// A person who drives a robot along a world's tour, by its odometry: publishes /cmd_vel itself, or only what
/// a joystick says (/joy). Knows nothing of aisle.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include "ros/messages.hpp"
#include "ros/participant.hpp"
#include "world.hpp"

namespace robots {
namespace {

constexpr double kSpeed_mps = 0.3, kTurnRate_radps = 0.6, kAhead_m = 0.5, kThere_m = 0.1, kLate_s = 20;
constexpr int kDeadManButton = 4, kEndButton = 1;

struct RequestedMotion {
  double speed_mps = 0;
  double turn_rate_radps = 0;
};

Pose2 inverse(const Pose2& T) {
  const Pose2 turned = Pose2{0, 0, -T.heading_rad} * Pose2{-T.x, -T.y, 0};
  return {turned.x, turned.y, -T.heading_rad};
}

Pose2 pose_of(const Odometry& message) {
  const auto& [position, orientation] = message.pose;
  return {position.x, position.y, 2 * std::atan2(orientation.z, orientation.w)};
}

/// Follows a point that runs along the tour ahead of the vehicle.
class TourFollower {
 public:
  explicit TourFollower(const World& world) : world_(world) {}

  bool is_there() const { return next_ == world_.tour.size(); }

  RequestedMotion requested(const Pose2& T_world_vehicle) {
    while (!is_there() && ahead(T_world_vehicle, world_.tour[next_]) < (is_last() ? kThere_m : kAhead_m))
      ++next_;
    if (is_there()) return {};
    const Pose2 seen = inverse(T_world_vehicle) * carrot(T_world_vehicle);
    const double bearing_rad = std::atan2(seen.y, seen.x);
    return {kSpeed_mps * std::clamp(1 - std::abs(bearing_rad), 0.0, 1.0),
            std::clamp(1.5 * bearing_rad, -kTurnRate_radps, kTurnRate_radps)};
  }

 private:
  bool is_last() const { return next_ + 1 == world_.tour.size(); }

  /// How far it still is to a place, along the piece of the tour that leads there.
  double ahead(const Pose2& T_world_vehicle, const Pose2& place) const {
    const Pose2& from = world_.tour[next_ - 1];
    const double length_m = std::hypot(place.x - from.x, place.y - from.y);
    return ((place.x - T_world_vehicle.x) * (place.x - from.x) +
            (place.y - T_world_vehicle.y) * (place.y - from.y)) /
           length_m;
  }

  Pose2 carrot(const Pose2& T_world_vehicle) const {
    const Pose2 &from = world_.tour[next_ - 1], &to = world_.tour[next_];
    const double length_m = std::hypot(to.x - from.x, to.y - from.y);
    const double back_m = ahead(T_world_vehicle, to) - kAhead_m;
    return {to.x - back_m * (to.x - from.x) / length_m, to.y - back_m * (to.y - from.y) / length_m, 0};
  }

  const World& world_;
  std::size_t next_ = 1;
};

Joy joystick_for(const RequestedMotion& requested, bool is_there) {
  Joy joy;
  joy.axes = {static_cast<float>(requested.turn_rate_radps / kTurnRate_radps),
              static_cast<float>(requested.speed_mps / kSpeed_mps)};
  joy.buttons.resize(5);
  joy.buttons[kDeadManButton] = 1;
  joy.buttons[kEndButton] = is_there ? 1 : 0;
  return joy;
}

/// @return whether it got there
bool drive(const World& world, unsigned domain, bool by_joystick) {
  const Participant participant(domain);
  const Subscription<Odometry> odometry(participant, "/odom", Quality::kSensor);
  std::optional<Publisher<Twist>> commands;
  std::optional<Publisher<Joy>> joystick;
  if (by_joystick) {
    joystick.emplace(participant, "/joy", Quality::kDefault);
  } else {
    commands.emplace(participant, "/cmd_vel", Quality::kDefault);
  }
  TourFollower follower(world);
  std::optional<Pose2> T_odom_start;
  for (int still = 0; still < 50;) {
    const auto message = odometry.wait(kLate_s);
    if (!message) return false;
    const Pose2 T_odom_vehicle = pose_of(*message);
    if (!T_odom_start) T_odom_start = T_odom_vehicle;
    const RequestedMotion requested =
        follower.requested(world.T_world_start * inverse(*T_odom_start) * T_odom_vehicle);
    if (follower.is_there()) ++still;
    if (joystick) {
      joystick->publish(joystick_for(requested, follower.is_there()));
    } else {
      Twist twist;
      twist.linear.x = requested.speed_mps;
      twist.angular.z = requested.turn_rate_radps;
      commands->publish(twist);
    }
  }
  return true;
}

}  // namespace
}  // namespace robots

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: robot_person WORLD DOMAIN [--joy]\n";
    return 2;
  }
  try {
    const robots::World world = robots::read_world(argv[1]);
    if (world.tour.size() < 2) throw std::runtime_error("the world has no tour");
    const bool is_there = robots::drive(world, static_cast<unsigned>(std::atoi(argv[2])),
                                        argc > 3 && argv[3] == std::string("--joy"));
    return is_there ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "robot_person: " << error.what() << '\n';
    return 1;
  }
}
