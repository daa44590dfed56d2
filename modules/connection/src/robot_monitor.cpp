#include "robot_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {
namespace {

constexpr double kClockLate_s = 0.5;   // of aisle's own time: held
constexpr double kClockStands_s = 10;  // of aisle's own time: the mission ends
constexpr double kOdometryGone = 4;    // times silent_max_s: the mission ends
constexpr double kAfterJump_s = 1;     // it stands still for so long after a jump that was left out

}  // namespace

RobotMonitor::RobotMonitor(const Connection& connection, const VehicleDescription& vehicle,
                           RobotIntake& intake, const Clock& clock)
    : connection_(connection), intake_(intake), clock_(clock) {
  const auto lock = intake_.lock();
  connected_s_ = intake_.now_s();
  const RobotState& state = intake_.state();
  if (vehicle.scanner)
    sensors_.push_back({intake_.scans().topic, intake_.scans().type, state.scan, vehicle.cycle_s,
                        connection_.scan.silent_max_s});
  for (std::size_t i = 0; i < state.cameras.size(); ++i)
    sensors_.push_back({intake_.camera_name(i), intake_.images(i).type, state.cameras[i].stream,
                        vehicle.cameras[i].period_s, connection_.cameras[i].silent_max_s});
}

double RobotMonitor::silent_s(double arrived_s) const {
  return intake_.now_s() - std::max(arrived_s, connected_s_);
}

std::string RobotMonitor::why_end() const {
  const RobotState& state = intake_.state();
  if (!state.broken.empty()) return state.broken;
  if (connection_.clock == ConnectedClock::kRos && clock_.now_s() - state.clock_arrived_s > kClockStands_s)
    return fmt::format("/clock stands still for {:.0f} s", kClockStands_s);
  for (const Sensor& sensor : sensors_) {
    if (silent_s(sensor.stream.arrived_s) > sensor.silent_max_s)
      return silence(sensor.name, sensor.type, sensor.silent_max_s);
  }
  const double odometry_max_s = kOdometryGone * connection_.odometry.silent_max_s;
  if (silent_s(state.odometry_arrived_s) > odometry_max_s)
    return silence(intake_.odometry().topic, intake_.odometry().type, odometry_max_s);
  return {};
}

std::string RobotMonitor::silence(const std::string& name, const std::string& type, double for_s) const {
  const auto& unreadable = intake_.state().unreadable_in_a_row;
  const auto count = unreadable.find(type);
  const bool arrives = count != unreadable.end() && count->second > 0;
  return fmt::format("{} silent for {:.1f} s{}", name, for_s,
                     arrives ? fmt::format(": what arrives cannot be read as {}", type) : "");
}

std::string RobotMonitor::why_held() const {
  const RobotState& state = intake_.state();
  const double now_s = intake_.now_s();
  for (std::size_t i = 0; i < state.emergency_stops.size(); ++i) {
    const std::string topic = connection_.topic(connection_.emergency_stops[i].topic);
    if (state.emergency_stops[i].is_pressed) return fmt::format("the emergency stop {} is pressed", topic);
    if (state.emergency_stops[i].is_silent(connection_.emergency_stops[i].silent_max_s, now_s))
      return fmt::format("the emergency stop {} is silent", topic);
  }
  if (connection_.clock == ConnectedClock::kRos && clock_.now_s() - state.clock_arrived_s > kClockLate_s)
    return "/clock stands still";
  if (silent_s(state.odometry_arrived_s) > connection_.odometry.silent_max_s)
    return fmt::format("{} is silent", intake_.odometry().topic);
  if (now_s - state.jump_s < kAfterJump_s) return state.jump;
  return why_late();
}

/// By the stamps: what arrives may be old.
std::string RobotMonitor::why_late() const {
  const std::string& odometry = intake_.odometry().topic;
  for (const Sensor& sensor : sensors_) {
    const double late_s = intake_.state().trail.newest_s() - sensor.stream.newest_end_s;
    if (late_s > sensor.period_s + connection_.commands.age_max_s)
      return fmt::format("{} is far behind {}", sensor.name, odometry);
    if (-late_s > sensor.period_s + connection_.odometry.silent_max_s)
      return fmt::format("{} is far behind {}", odometry, sensor.name);
  }
  return {};
}

void RobotMonitor::add_ages(ConnectionCounts& counts) const {
  const RobotState& state = intake_.state();
  const double now_s = intake_.now_s();
  if (!connection_.scan.topic.empty()) counts.scan_age_s = now_s - state.scan.arrived_s;
  for (const ArrivingImages& camera : state.cameras)
    counts.image_age_s = std::max(counts.image_age_s.value_or(0), now_s - camera.stream.arrived_s);
  counts.odometry_age_s = now_s - state.odometry_arrived_s;
}

}  // namespace aisle
