#include "first_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command_topic.hpp"
#include "odometry_reading.hpp"

namespace aisle {
namespace {

constexpr double kPatience_s = 10;
constexpr double kAskAgain_s = 0.05;
constexpr std::size_t kPeriodsNeeded = 3;
constexpr double kStepMin_rad = 0.01 * kDegree;
constexpr double kStepMax_rad = 45 * kDegree;
constexpr double kLevel = 0.98;         // cosine of about 11 degrees
constexpr double kUnknownRange_m = 30;  // of a scanner that does not say it

/// "/lidar (sensor_msgs/msg/LaserScan), /odom (nav_msgs/msg/Odometry)"
std::string published(const std::vector<WireEndpoint>& endpoints) {
  std::vector<std::string> texts;
  for (const WireEndpoint& endpoint : endpoints) {
    if (endpoint.kind == WireEndpoint::Kind::kPublisher)
      texts.push_back(fmt::format("{} ({})", endpoint.topic, endpoint.type));
  }
  texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
  return texts.empty() ? "nothing at all" : fmt::format("{}", fmt::join(texts, ", "));
}

/// Why nothing readable came on a topic, by what is published instead.
Problem why_silent(const NeededTopic& needed, const WireSubscription& subscription,
                   const std::vector<WireEndpoint>& endpoints, const Connection& connection) {
  const auto problem = [&](std::string what) { return Problem{{needed.topic}, std::move(what)}; };
  if (const std::string quality = subscription.incompatible_quality(); !quality.empty())
    return problem(
        fmt::format("is published with another quality of service ({}); aisle cannot take it", quality));
  for (const WireEndpoint& endpoint : endpoints) {
    if (endpoint.kind != WireEndpoint::Kind::kPublisher || endpoint.topic != needed.topic) continue;
    if (endpoint.type != needed.type)
      return problem(fmt::format("is a {}, not a {}", endpoint.type, needed.type));
    return problem(
        fmt::format("is published, but nothing readable of it arrived in {:.0f} s: is its "
                    "publisher stopped, or does it not write plain CDR (XCDR1)?",
                    kPatience_s));
  }
  const ConnectedNetwork& network = connection.network;
  return problem(fmt::format("nobody publishes it as {} in domain {} at {}; there is {}", needed.type,
                             network.domain, fmt::join(network.peers, ", "), published(endpoints)));
}

std::optional<Eigen::Isometry3d> mount_of(const Connection& connection, const RobotState& state) {
  return state.transforms.find(connection.frames.base, state.scan_frame);
}

bool needs_mount(const Connection& connection) {
  return connection.frames.mounts == ConnectedFrames::Mounts::kTransforms;
}

bool lacks_clock(const Connection& connection, const RobotState& state) {
  return connection.clock == ConnectedClock::kRos && !state.ros_clock_s;
}

bool has_met(const Connection& connection, const RobotState& state) {
  return !lacks_clock(connection, state) && state.scan_periods_s.size() >= kPeriodsNeeded &&
         !state.scans.empty() && !state.trail.empty() &&
         (!needs_mount(connection) || mount_of(connection, state));
}

Problems what_is_missing(const Connection& connection, RobotIntake& intake, const Wire& wire) {
  const std::vector<WireEndpoint> endpoints = wire.endpoints();
  const auto needed = intake.needed_topics();
  const auto lock = intake.lock();
  const RobotState& state = intake.state();
  Problems problems;
  if (!state.broken.empty()) problems.push_back({{connection.file}, state.broken});
  if (state.scans.empty()) {
    problems.push_back(why_silent(needed[0], intake.scans(), endpoints, connection));
  } else if (state.scan_periods_s.size() < kPeriodsNeeded) {
    problems.push_back({{needed[0].topic},
                        fmt::format("{} of its stamps were not newer than the one before; 'clock: arrival' "
                                    "does without them",
                                    state.counts.out_of_order)});
  } else if (needs_mount(connection) && !mount_of(connection, state)) {
    problems.push_back(
        {{"/tf_static"},
         fmt::format("no fixed transforms lead from '{}' to '{}', the frame of the scans: name the robot's "
                     "frame with 'frames: {{base: ...}}', or give the scanner in the vehicle file and say "
                     "'frames: {{mounts: file}}'",
                     connection.frames.base, state.scan_frame)});
  }
  if (state.trail.empty())
    problems.push_back(why_silent(needed[1], intake.odometry(), endpoints, connection));
  return problems;
}

/// In [-pi, pi). Messages have angles of few digits: a full circle may begin a little before -pi.
double first_angle_rad(const BagScan& scan) {
  constexpr double kFewDigits_rad = 1e-5;
  const double angle_rad = scan.beams.first_angle_rad;
  return std::abs(angle_rad + kPi) < kFewDigits_rad ? -kPi : wrap_angle(angle_rad);
}

/// The scanner as the scans and the mount have it.
void take_scanner(const Connection& connection, const RobotState& state, FirstContact& contact) {
  std::optional<LaserScanner>& scanner = contact.vehicle.scanner;
  if (!needs_mount(connection)) return;
  const Eigen::Isometry3d T_base_laser = *mount_of(connection, state);
  contact.is_upside_down = T_base_laser.linear()(2, 2) < 0;
  BagScan scan = state.scans.back();
  if (contact.is_upside_down) turn_over(scan);
  const Vec2& axle = connection.frames.p_base_axle_m;
  scanner = LaserScanner{first_angle_rad(scan), scan.beams.angle_step_rad,
                         scan.range_max_m > 0 ? scan.range_max_m : kUnknownRange_m,
                         Pose2{axle.x(), axle.y(), 0}.inverse() * in_the_plane(T_base_laser)};
}

double median_period_s(const RobotState& state) {
  std::vector<double> periods_s = state.scan_periods_s;
  std::nth_element(periods_s.begin(), periods_s.begin() + 1, periods_s.end());
  return periods_s[1];
}

Problems check_battery(const Connection& connection, const RobotState& state) {
  if (connection.battery.topic.empty() || !state.charge || *state.charge >= connection.battery.charge_min)
    return {};
  return {Problem{{connection.topic(connection.battery.topic)},
                  fmt::format("the battery has {:.0f} % left; no mission starts below {:.0f} %",
                              100 * *state.charge, 100 * connection.battery.charge_min)}};
}

/// Waits until it is known who reads the commands; discovery may take seconds.
Result<CommandKind> reader_of_commands(const Connection& connection, RobotIntake& intake,
                                       const ConnectedVehicle::Surroundings& surroundings, double until_s) {
  const std::string topic = connection.topic(connection.commands.topic);
  for (;;) {
    const auto endpoints = surroundings.wire.endpoints();
    auto kind = kind_read(endpoints, topic, connection.commands.kind);
    if (kind) {
      const std::string obstacle = command_obstacle(endpoints, topic, *kind);
      if (obstacle.empty()) return kind;
      return Problem{{topic}, obstacle + ": aisle does not drive beside it"};
    }
    if (surroundings.clock.now_s() > until_s) return kind;
    surroundings.progress.report("waiting for the robot", 0, 0);
    auto lock = intake.lock();
    intake.wait(lock, kAskAgain_s);
  }
}

}  // namespace

Result<FirstContact> make_contact(const Connection& connection, const VehicleDescription& vehicle,
                                  RobotIntake& intake, const ConnectedVehicle::Surroundings& surroundings) {
  const auto limits = limits_over(connection, vehicle.limits);
  if (!limits) return limits.problems();
  if (!needs_mount(connection) && !vehicle.scanner)
    return Problem{{connection.file, 0, "frames.mounts"},
                   "the vehicle file has no scanner, so its mount cannot be 'file'"};
  const double until_s = surroundings.clock.now_s() + kPatience_s;
  for (bool met = false; !met;) {
    surroundings.progress.report("waiting for the robot", 0, 0);
    {
      auto lock = intake.lock();
      met = has_met(connection, intake.state());
      if (!met) intake.wait(lock, kAskAgain_s);
    }
    if (!met && surroundings.clock.now_s() > until_s)
      return what_is_missing(connection, intake, surroundings.wire);
  }
  const auto kind = reader_of_commands(connection, intake, surroundings, until_s);
  if (!kind) return kind.problems();
  FirstContact contact{.vehicle = vehicle, .commands = *kind};
  contact.vehicle.limits = *limits;
  contact.vehicle.cameras.clear();
  const auto lock = intake.lock();
  RobotState& state = intake.state();
  if (Problems problems = check_battery(connection, state); !problems.empty()) return problems;
  take_scanner(connection, state, contact);
  if (const double step_rad = contact.vehicle.scanner->angle_step_rad;
      step_rad < kStepMin_rad || step_rad > kStepMax_rad)
    return Problem{
        {intake.needed_topics()[0].topic},
        fmt::format("its readings are {:g} deg apart, as those of no scanner are", to_degrees(step_rad))};
  contact.grid = {*contact.vehicle.scanner, state.scans.back().ranges_m.size()};
  contact.vehicle.cycle_s = median_period_s(state);
  make_steps_fine(contact.vehicle.differential);
  if (needs_mount(connection) && std::abs(mount_of(connection, state)->linear()(2, 2)) < kLevel)
    surroundings.note("the scanner is tilted; its scans are taken as if it were level");
  return contact;
}

}  // namespace aisle
