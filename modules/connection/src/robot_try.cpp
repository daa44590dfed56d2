#include "aisle/connection/robot_try.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kDistance_m = 0.1;
constexpr double kTurn_rad = 10 * kDegree;
constexpr double kSpeed_mps = 0.1;
constexpr double kTurnRate_rad_s = 15 * kDegree;
constexpr double kSettle_s = 1;
constexpr double kSilent_s = 1.5;        // robots that stop by themselves do so within half a second
constexpr double kStillMoving_m = 0.02;  // in the last half of that
constexpr double kRoomAhead_m = 0.4;
constexpr double kRoomBehind_m = 0.2;
constexpr double kRoomBeside_m = 0.1;
constexpr double kStandingShare = 0.3;
constexpr double kScaleMin = 0.6, kScaleMax = 1.5;  // of commands: controllers have dead bands and lags
constexpr double kOdometryShare = 0.25;
constexpr double kOdometry_m = 0.02;
constexpr double kOdometry_rad = 2.5 * kDegree;

/// One of the moves, with what it is to change.
struct Move {
  const char* name;
  Command command;
  bool is_turn;
};

/// The vehicle as it is seen while it is tried.
class Trial {
 public:
  explicit Trial(ConnectedVehicle& vehicle) : vehicle_(vehicle) {}

  /// Drives for a time. @return whether the vehicle still tells something and touches nothing
  bool drive(const Command& command, double for_s) {
    const double until_s = stamp_s_ + for_s;
    do {
      vehicle_.act(command);
      if (!look()) return false;
    } while (stamp_s_ < until_s);
    return true;
  }

  bool look() {
    const auto observation = vehicle_.sense();
    if (!observation) {
      ended_because_ = vehicle_.end_reason();
      return false;
    }
    stamp_s_ = observation->stamp_s;
    T_by_odometry_ = T_by_odometry_ * odometry_step(vehicle_.description(), observation->odometry);
    points_of(*vehicle_.description().scanner, observation->scan->ranges_m, points_);
    scans_.step(points_, stamp_s_);
    if (observation->bumper_pressed) ended_because_ = "it touches something";
    return ended_because_.empty();
  }

  const Pose2& by_odometry() const { return T_by_odometry_; }
  Pose2 by_scans() const {
    const Pose2& T_vehicle_laser = vehicle_.description().scanner->T_vehicle_laser;
    return T_vehicle_laser * scans_.T_first_laser() * T_vehicle_laser.inverse();
  }
  const std::vector<Vec2>& points() const { return points_; }
  const std::string& ended_because() const { return ended_because_; }

 private:
  ConnectedVehicle& vehicle_;
  ScanOdometry scans_;
  Pose2 T_by_odometry_;
  double stamp_s_ = 0;
  std::vector<Vec2> points_;  ///< of the latest scan, in the laser's frame
  std::string ended_because_;
};

/// What is in the way of the moves; empty: nothing that the scanner sees.
std::string in_the_way(const VehicleDescription& vehicle, const std::vector<Vec2>& points_laser) {
  Footprint room = vehicle.footprint;
  room.front_m += kRoomAhead_m;
  room.rear_m += kRoomBehind_m;
  room.width_m += 2 * kRoomBeside_m;
  for (const Vec2& p_laser : points_laser) {
    const Vec2 p = vehicle.scanner->T_vehicle_laser * p_laser;
    const bool is_own_part = off_footprint_m(vehicle.footprint, p) < 0;
    if (!is_own_part && off_footprint_m(room, p) < 0)
      return fmt::format(
          "something stands {:.2f} m ahead and {:.2f} m to the left of its base_link: the robot "
          "needs {:.1f} m ahead, {:.1f} m behind and {:.1f} m at its sides",
          p.x(), p.y(), kRoomAhead_m, kRoomBehind_m, kRoomBeside_m);
  }
  return {};
}

/// Ahead and back, left and right: by steering where the vehicle cannot turn on the spot.
std::vector<Move> moves_of(const VehicleDescription& vehicle) {
  const double speed_mps =
      std::min({kSpeed_mps, vehicle.limits.speed_max_mps, vehicle.limits.reverse_speed_max_mps});
  if (vehicle.is_differential) {
    const double rate_rad_s = std::min(kTurnRate_rad_s, vehicle.limits.turn_rate_max_rad_s);
    return {{"ahead", {.speed_mps = speed_mps}, false},
            {"back", {.speed_mps = -speed_mps}, false},
            {"left", {.turn_rate_rad_s = rate_rad_s}, true},
            {"right", {.turn_rate_rad_s = -rate_rad_s}, true}};
  }
  const double steering_rad = vehicle.limits.steering_max_rad / 2;
  return {{"ahead", {.speed_mps = speed_mps}, false},
          {"back", {.speed_mps = -speed_mps}, false},
          {"ahead to the left", {.speed_mps = speed_mps, .steering_rad = steering_rad}, true},
          {"back to the right", {.speed_mps = -speed_mps, .steering_rad = steering_rad}, true}};
}

/// How long a command is given: for 0.1 m, or for 10 degrees on the spot.
double duration_s(const Move& move) {
  return move.command.speed_mps != 0 ? kDistance_m / std::abs(move.command.speed_mps)
                                     : kTurn_rad / std::abs(move.command.turn_rate_rad_s);
}

/// What was commanded from one moment to another.
Pose2 commanded_between(const Arc& from, const Arc& to) {
  return end_pose({to.length_m - from.length_m, to.turn_rad - from.turn_rad});
}

std::string amount(double value, bool is_turn) {
  return is_turn ? fmt::format("{:.1f} deg", to_degrees(value)) : fmt::format("{:.3f} m", value);
}

/// What a move shows to be wrong.
void judge_move(const TriedMove& tried, bool is_turn, Problems& problems) {
  const auto part = [&](const Pose2& T) { return is_turn ? wrap_angle(T.theta) : T.x; };
  const double commanded = part(tried.commanded), odometry = part(tried.by_odometry),
               scans = part(tried.by_scans);
  const auto say = [&](std::string what) { problems.push_back({{tried.name}, std::move(what)}); };
  const std::string both =
      fmt::format("commanded {}, seen {}", amount(commanded, is_turn), amount(scans, is_turn));
  if (!is_turn && std::abs(tried.by_scans.y) > std::max(kOdometry_m, std::abs(scans))) {
    say(fmt::format("it moved sideways by {:.3f} m: are the scanner's mount or the axes turned?",
                    tried.by_scans.y));
  } else if (scans * commanded < 0 && std::abs(scans) > kStandingShare * std::abs(commanded)) {
    say(both + ": the wrong way; a sign is wrong, or the scanner is mounted the other way round");
  } else if (std::abs(scans) < kStandingShare * std::abs(commanded)) {
    say(both + ": it hardly moved");
  } else if (scans / commanded < kScaleMin || scans / commanded > kScaleMax) {
    say(both + ": the scale of speeds is wrong");
  }
  const double allowed = std::max(is_turn ? kOdometry_rad : kOdometry_m, kOdometryShare * std::abs(scans));
  if (std::abs(odometry - scans) > allowed)
    say(fmt::format("its odometry says {}, its scans say {}", amount(odometry, is_turn),
                    amount(scans, is_turn)));
}

/// Lets commands end while the robot moves.
bool stops_by_itself(ConnectedVehicle& vehicle, Trial& trial, const Command& ahead) {
  if (!trial.drive(ahead, 0.5)) return false;
  vehicle.fall_silent(true);
  trial.drive(ahead, kSilent_s / 2);
  const Pose2 T_half = trial.by_odometry();
  trial.drive(ahead, kSilent_s / 2);
  vehicle.fall_silent(false);
  const double moved_m = (trial.by_odometry().position() - T_half.position()).norm();
  trial.drive({}, kSettle_s);
  return moved_m < kStillMoving_m;
}

}  // namespace

Result<RobotTry> try_robot(ConnectedVehicle& vehicle) {
  const VehicleDescription& description = vehicle.description();
  Trial trial(vehicle);
  const auto ended = [&] { return Problem{{"connect try"}, "the robot ended it: " + trial.ended_because()}; };
  if (!trial.drive({}, kSettle_s)) return ended();
  if (const std::string obstacle = in_the_way(description, trial.points()); !obstacle.empty())
    return Problem{{"connect try"}, obstacle};
  RobotTry result;
  const std::vector<Move> moves = moves_of(description);
  for (const Move& move : moves) {
    const Pose2 T_odometry = trial.by_odometry(), T_scans = trial.by_scans();
    const Arc before = vehicle.commanded();
    if (!trial.drive(move.command, duration_s(move)) || !trial.drive({}, kSettle_s)) return ended();
    result.moves.push_back({move.name, commanded_between(before, vehicle.commanded()),
                            between(T_odometry, trial.by_odometry()), between(T_scans, trial.by_scans())});
    judge_move(result.moves.back(), move.is_turn, result.problems);
    if (!result.problems.empty()) return result;  // what goes wrong once is not tried again
  }
  result.stops_by_itself = stops_by_itself(vehicle, trial, moves.front().command);
  if (!trial.ended_because().empty()) return ended();
  return result;
}

}  // namespace aisle
