#include "first_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/median.hpp"
#include "camera_contact.hpp"
#include "command_topic.hpp"
#include "odometry_reading.hpp"

namespace aisle {
namespace {

constexpr double kPatience_s = 10;
constexpr double kAskAgain_s = 0.05;
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
Problem why_silent(const NeededTopic& needed, const std::vector<WireEndpoint>& endpoints,
                   const Connection& connection) {
  const auto problem = [&](std::string what) { return Problem{{needed.topic}, std::move(what)}; };
  if (const std::string quality = needed.subscription->incompatible_quality(); !quality.empty())
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
  return state.transforms.find(connection.frames.base, state.scan.frame);
}

bool has_scanner(const Connection& connection) {
  return !connection.scan.topic.empty();
}

bool needs_scanner_mount(const Connection& connection) {
  return connection.frames.mounts == ConnectedFrames::Mounts::kTransforms;
}

bool lacks_clock(const Connection& connection, const RobotState& state) {
  return connection.clock == ConnectedClock::kRos && !state.ros_clock_s;
}

bool has_met_scanner(const Connection& connection, const RobotState& state) {
  return state.scan.periods_s.size() >= kPeriodsNeeded && !state.scans.empty() &&
         (!needs_scanner_mount(connection) || mount_of(connection, state));
}

bool has_met(const Connection& connection, const VehicleDescription& vehicle, const RobotState& state) {
  for (std::size_t i = 0; i < connection.cameras.size(); ++i) {
    if (lack_of(connection, vehicle, state, i) != CameraLack::kNothing) return false;
  }
  return !lacks_clock(connection, state) && !state.trail.empty() &&
         (!has_scanner(connection) || has_met_scanner(connection, state));
}

Problem stamps_stand(const std::string& topic, const RobotState& state) {
  return {{topic},
          fmt::format("{} of its stamps were not newer than the one before; 'clock: arrival' does without "
                      "them",
                      state.counts.out_of_order)};
}

Problem no_mount(const Connection& connection, const std::string& frame, const char* sensor) {
  return {{"/tf_static"},
          fmt::format("no fixed transforms lead from '{}' to '{}', the frame of the {}s: name the robot's "
                      "frame with 'frames: {{base: ...}}', or give the {} in the vehicle file and say "
                      "'frames: {{mounts: file}}'",
                      connection.frames.base, frame, sensor,
                      sensor == std::string_view("scan") ? "scanner" : "camera")};
}

void what_scanner_lacks(const Connection& connection, const RobotIntake& intake, const RobotState& state,
                        const std::vector<WireEndpoint>& endpoints, Problems& problems) {
  if (state.scans.empty()) {
    problems.push_back(why_silent(intake.scans(), endpoints, connection));
  } else if (state.scan.periods_s.size() < kPeriodsNeeded) {
    problems.push_back(stamps_stand(intake.scans().topic, state));
  } else if (needs_scanner_mount(connection) && !mount_of(connection, state)) {
    problems.push_back(no_mount(connection, state.scan.frame, "scan"));
  }
}

/// Why no image came: what is wrong with the camera that aisle opened, or with the topic.
Problem why_blind(const Connection& connection, const RobotIntake& intake,
                  const std::vector<WireEndpoint>& endpoints, std::size_t which) {
  if (!connection.cameras[which].topic.empty())
    return why_silent(intake.images(which), endpoints, connection);
  const std::string problem = intake.camera_problem(which);
  return {{intake.camera_name(which)}, problem.empty() ? std::string("no image came of it") : problem};
}

void what_camera_lacks(const Connection& connection, const VehicleDescription& vehicle,
                       const RobotIntake& intake, const RobotState& state,
                       const std::vector<WireEndpoint>& endpoints, std::size_t which, Problems& problems) {
  const ConnectedCamera& camera = connection.cameras[which];
  switch (lack_of(connection, vehicle, state, which)) {
    case CameraLack::kNothing:
      return;
    case CameraLack::kImages:
      return problems.push_back(why_blind(connection, intake, endpoints, which));
    case CameraLack::kStamps:
      return problems.push_back(stamps_stand(intake.camera_name(which), state));
    case CameraLack::kCalibration:
      return problems.push_back(
          {{connection.topic(camera.calibration_topic())},
           fmt::format("nothing came on it ({}), and the vehicle file has no camera '{}': nobody says the "
                       "lens of {}. 'aisle calibrate camera' measures it",
                       ros::CameraInfo::kType, camera.name, intake.camera_name(which))});
    case CameraLack::kMount:
      return problems.push_back(no_mount(connection, state.cameras[which].stream.frame, "image"));
  }
}

Problems what_is_missing(const Connection& connection, const VehicleDescription& vehicle, RobotIntake& intake,
                         const Wire& wire) {
  const std::vector<WireEndpoint> endpoints = wire.endpoints();
  const auto lock = intake.lock();
  const RobotState& state = intake.state();
  Problems problems;
  if (!state.broken.empty()) problems.push_back({{connection.file}, state.broken});
  if (has_scanner(connection)) what_scanner_lacks(connection, intake, state, endpoints, problems);
  for (std::size_t i = 0; i < connection.cameras.size(); ++i)
    what_camera_lacks(connection, vehicle, intake, state, endpoints, i, problems);
  if (state.trail.empty()) problems.push_back(why_silent(intake.odometry(), endpoints, connection));
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
  if (!needs_scanner_mount(connection)) return;
  const Eigen::Isometry3d T_base_laser = *mount_of(connection, state);
  contact.is_upside_down = T_base_laser.linear()(2, 2) < 0;
  BagScan scan = state.scans.back();
  if (contact.is_upside_down) turn_over(scan);
  const Vec2& axle = connection.frames.p_base_axle_m;
  scanner = LaserScanner{first_angle_rad(scan), scan.beams.angle_step_rad,
                         scan.range_max_m > 0 ? scan.range_max_m : kUnknownRange_m,
                         Pose2{axle.x(), axle.y(), 0}.inverse() * in_the_plane(T_base_laser)};
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

/// What the connection asks for that cannot be.
Problems check_sensors(const Connection& connection, const VehicleDescription& vehicle) {
  if (!has_scanner(connection) && connection.cameras.empty())
    return {{{connection.file}, "has neither scanner nor camera that the mission could drive by"}};
  if (has_scanner(connection) && !needs_scanner_mount(connection) && !vehicle.scanner)
    return {{{connection.file, 0, "frames.mounts"},
             "the vehicle file has no scanner, so its mount cannot be 'file'"}};
  return {};
}

/// Waits until everything is known that must be; up to 10 s.
Problems meet(const Connection& connection, const VehicleDescription& vehicle, RobotIntake& intake,
              const ConnectedVehicle::Surroundings& surroundings, double until_s) {
  for (;;) {
    surroundings.progress.report("waiting for the robot", 0, 0);
    {
      auto lock = intake.lock();
      if (has_met(connection, vehicle, intake.state())) return {};
      intake.wait(lock, kAskAgain_s);
    }
    if (surroundings.clock.now_s() > until_s)
      return what_is_missing(connection, vehicle, intake, surroundings.wire);
  }
}

Problems contact_scanner(const Connection& connection, const RobotIntake& intake, const RobotState& state,
                         const ConnectedVehicle::Surroundings& surroundings, FirstContact& contact) {
  take_scanner(connection, state, contact);
  if (const double step_rad = contact.vehicle.scanner->angle_step_rad;
      step_rad < kStepMin_rad || step_rad > kStepMax_rad)
    return {
        {{intake.scans().topic},
         fmt::format("its readings are {:g} deg apart, as those of no scanner are", to_degrees(step_rad))}};
  contact.grid = {*contact.vehicle.scanner, state.scans.back().ranges_m.size()};
  contact.vehicle.cycle_s = median(state.scan.periods_s);
  if (needs_scanner_mount(connection) && std::abs(mount_of(connection, state)->linear()(2, 2)) < kLevel)
    surroundings.note("the scanner is tilted; its scans are taken as if it were level");
  return {};
}

Problems contact_cameras(const Connection& connection, const VehicleDescription& vehicle, RobotIntake& intake,
                         const ConnectedVehicle::Surroundings& surroundings, FirstContact& contact) {
  contact.vehicle.cameras.clear();
  for (std::size_t i = 0; i < connection.cameras.size(); ++i) {
    Problems notes;
    auto seen = seen_camera(connection, vehicle, intake, i, notes);
    if (!seen) return seen.problems();
    for (const Problem& note : notes) surroundings.note(to_string(note));
    contact.vehicle.cameras.push_back(seen->camera);
    contact.cameras.push_back(std::move(*seen));
  }
  if (!has_scanner(connection)) contact.vehicle.cycle_s = contact.vehicle.cameras.front().period_s;
  return {};
}

}  // namespace

Result<FirstContact> make_contact(const Connection& connection, const VehicleDescription& vehicle,
                                  RobotIntake& intake, const ConnectedVehicle::Surroundings& surroundings) {
  const auto limits = limits_over(connection, vehicle.limits);
  if (!limits) return limits.problems();
  if (Problems problems = check_sensors(connection, vehicle); !problems.empty()) return problems;
  const double until_s = surroundings.clock.now_s() + kPatience_s;
  if (Problems problems = meet(connection, vehicle, intake, surroundings, until_s); !problems.empty())
    return problems;
  FirstContact contact;
  contact.vehicle = vehicle;
  if (!connection.commands.topic.empty()) {
    const auto kind = reader_of_commands(connection, intake, surroundings, until_s);
    if (!kind) return kind.problems();
    contact.commands = *kind;
  }
  contact.vehicle.limits = *limits;
  make_steps_fine(contact.vehicle.differential);
  const auto lock = intake.lock();
  const RobotState& state = intake.state();
  if (Problems problems = check_battery(connection, state); !problems.empty()) return problems;
  contact.vehicle.scanner = has_scanner(connection) ? vehicle.scanner : std::nullopt;
  if (Problems problems = has_scanner(connection)
                              ? contact_scanner(connection, intake, state, surroundings, contact)
                              : Problems();
      !problems.empty())
    return problems;
  if (Problems problems = contact_cameras(connection, vehicle, intake, surroundings, contact);
      !problems.empty())
    return problems;
  return contact;
}

}  // namespace aisle
