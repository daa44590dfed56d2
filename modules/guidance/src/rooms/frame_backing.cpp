#include "aisle/guidance/rooms/frame_backing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/guidance/rooms/route_floor.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

void FrameBackingParams::describe(FieldList& fields) {
  fields.flag("wanted", wanted, "it parks backwards in the frame");
  fields.group("search", search);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.real("turn_from_m", turn_from_m, {0, 10},
              "distance before its forward parking pose at which it turns about");
  fields.real("run_up_m", run_up_m, {0.1, 5}, "straight reverse path into the frame");
  fields.real("run_up_min_m", run_up_min_m, {0.05, 5},
              "the reverse path is shortened down to this if there is no space to turn");
  fields.real("look_s", look_s, {0.1, 60}, "time to look at the frame's near side");
  fields.real("wait_s", wait_s, {0, 100}, "time to wait for an obstacle before it plans another path");
  fields.count("plans_max", plans_max, {1, 100}, "paths to turn about that it plans before it gives up");
  fields.real("lateral_max_m", lateral_max_m, {0.001, 1},
              "lateral error above which it drives out and tries again");
  fields.angle("turned_max_deg", turned_max_rad, {0.1, 45}, "yaw error above which it tries again");
  fields.count("tries_max", tries_max, {1, 100}, "attempts; after the last one it stays where it is");
}

FrameBacking::FrameBacking(const FrameBackingParams& params, const VehicleDescription& vehicle,
                           const Vec2& size_m)
    : params_(params),
      vehicle_(vehicle),
      size_m_(size_m),
      search_(params.search, vehicle),
      driver_(vehicle, params.steering, params.speed),
      follower_(vehicle, params.steering),
      run_up_m_(params.run_up_m) {}

void FrameBacking::begin(FloorGrid floor, const Pose2& T_floor_odom) {
  floor_ = KnownFloor(std::move(floor));
  T_floor_odom_ = T_floor_odom;
  ++plans_;
  state_ = State::kSearching;
  driver_.drop();
  search_.stop();
}

void FrameBacking::see(std::span<const SeenEdge> edges, const Pose2& T_odom_vehicle) {
  constexpr double kNear_m = 2.5;  // points seen from farther away are inaccurate
  floor_.change([&](FloorGrid& grid) {
    FloorBox changed;
    for (const auto& [p_vehicle, seen_from_m] : edges) {
      const FloorCell cell = grid.cell_at(T_floor_odom_ * T_odom_vehicle * p_vehicle);
      if (seen_from_m > kNear_m || off_footprint_m(vehicle_.footprint, p_vehicle) < 0 ||
          grid.at(cell) == Floor::kOccupied)
        continue;
      grid.set(cell, Floor::kOccupied);
      changed.include(cell);
    }
    return changed;
  });
}

Decision FrameBacking::step(double stamp_s, const Pose2& T_odom_vehicle, const Pose2& T_odom_frame,
                            double steering_rad) {
  T_odom_vehicle_ = T_odom_vehicle;
  T_odom_frame_ = T_odom_frame;
  steering_rad_ = steering_rad;
  switch (state_) {
    case State::kNotBegun:
    case State::kSearching:
      return search();
    case State::kTurning:
      return turn(stamp_s);
    case State::kBlocked:
      return blocked();
    case State::kBackingIn:
      return back_in(stamp_s);
    case State::kLooking:
      return look_back(stamp_s);
    case State::kComingForward:
      return come_forward();
    case State::kLeaving:
      return leave();
  }
  return {};
}

Pose2 FrameBacking::T_odom_parked() const {
  const Footprint& footprint = vehicle_.footprint;
  return T_odom_frame_ * Pose2{(footprint.front_m - footprint.rear_m) / 2, 0, kPi};
}

Pose2 FrameBacking::off() const {
  return between(T_odom_parked(), T_odom_vehicle_);
}

/// How far it reverses beyond its parking pose to look: until its rear is on the frame's far line, so that
/// the near side is well in view; or before that line if the floor beyond it is not known to be free.
double FrameBacking::deeper_m() const {
  constexpr double kOntoLine_m = 0.03, kOffLine_m = 0.02;
  constexpr double kAnyClearance_m = -1;
  const double length_m = vehicle_.footprint.front_m + vehicle_.footprint.rear_m;
  const double to_line_m = std::max(0.0, (size_m_.x() - length_m) / 2);
  const Pose2 T_floor_onto_line = T_floor_odom_ * T_odom_parked() * Pose2{-(to_line_m + kOntoLine_m), 0, 0};
  return search_.footprint_clearance().fits_barely(floor_, T_floor_onto_line, {.free_m = kAnyClearance_m})
             ? to_line_m + kOntoLine_m
             : std::max(0.0, to_line_m - kOffLine_m);
}

void FrameBacking::search_path() {
  const Pose2 T_floor_vehicle = T_floor_odom_ * T_odom_vehicle_;
  const Pose2 T_floor_begin = T_floor_odom_ * T_odom_parked() * Pose2{run_up_m_, 0, 0};
  search_.look_for_path_to(T_floor_begin, T_floor_vehicle,
                           [p = T_floor_vehicle.position()](const Vec2& q) { return (q - p).norm(); });
}

/// Runs a portion of the search in each cycle while the vehicle stands.
Decision FrameBacking::search() {
  constexpr int kPortion = 400;
  constexpr double kShorter = 0.6;
  Decision searching{.state = "searching", .why = "a path to turn about"};
  if (search_.state() == CarSearch::State::kIdle) {
    floor_.change([this](FloorGrid& grid) {
      free_under(vehicle_.footprint, T_floor_odom_ * T_odom_vehicle_, grid);
      for (int i = 0; i * grid.cell_m() < run_up_m_; ++i)
        free_under(vehicle_.footprint, T_floor_odom_ * T_odom_parked() * Pose2{i * grid.cell_m(), 0, 0},
                   grid);
      return grid.known();
    });
    search_path();
    return searching;
  }
  switch (search_.advance(floor_, kPortion)) {
    case CarSearch::State::kFound:
      if (const Path path = search_.path(); !path.empty()) driver_.take(path);
      state_ = State::kTurning;
      return searching;
    case CarSearch::State::kNone:
      run_up_m_ *= kShorter;
      if (run_up_m_ < params_.run_up_min_m)
        return {.status = NavigatorStatus::kFailed,
                .state = "no room",
                .why = "found no path to turn about before the frame"};
      search_path();
      return searching;
    case CarSearch::State::kIdle:
    case CarSearch::State::kSearching:
      break;
  }
  return searching;
}

Decision FrameBacking::turn(double stamp_s) {
  const PathDriver::Step step =
      driver_.drive(floor_, search_.footprint_clearance(), T_floor_odom_ * T_odom_vehicle_, steering_rad_);
  if (step.state == PathDriver::State::kArrived || step.state == PathDriver::State::kNoPath) {
    state_ = State::kBackingIn;
    return back_in(stamp_s);
  }
  if (step.state != PathDriver::State::kBlocked) {
    is_held_up_ = false;
    return {.command = step.command,
            .state = "turning about",
            .why = fmt::format("{:.1f} m to go", driver_.left_m())};
  }
  if (!std::exchange(is_held_up_, true)) since_s_ = stamp_s;
  if (stamp_s - since_s_ > params_.wait_s) state_ = State::kBlocked;
  return {.command = step.command, .state = "waiting", .why = "something is in the path to turn about"};
}

Decision FrameBacking::blocked() {
  if (plans_ < params_.plans_max) return {.state = "waiting"};
  return {
      .status = NavigatorStatus::kFailed, .state = "blocked", .why = "could not turn about before the frame"};
}

/// Drives along the line through the middles of the frame's near and far side.
/// @param ahead_of_parked_m  distance of the stop from the parking pose, out of the frame; negative: deeper
Decision FrameBacking::drive_to(double ahead_of_parked_m, const char* state) const {
  constexpr double kBeyond_m = 1;
  const Pose2 off = FrameBacking::off();
  const double left_m = ahead_of_parked_m - off.x;
  const Gear gear = gear_of(left_m);
  const double speed_mps = std::clamp(std::sqrt(2 * params_.speed.deceleration_mps2 * std::abs(left_m)),
                                      params_.speed.speed_min_mps, params_.speed.speed_mps);
  const double path_m = std::abs(left_m) + 2 * kBeyond_m;
  const Path path(
      {{T_odom_parked() * Pose2{off.x - sign(gear) * kBeyond_m, 0, 0}, {sign(gear) * path_m, 0}}});
  const PathPoint point = path.nearest(T_odom_vehicle_.position(), 0, path_m);
  return {.command = follower_.follow(path, point, T_odom_vehicle_, speed_mps, steering_rad_),
          .state = state,
          .why = fmt::format("{:.2f} m to go, {:.3f} m to the side", std::abs(left_m), off.y)};
}

Decision FrameBacking::back_in(double stamp_s) {
  if (off().x > vehicle_.cycle_s * params_.speed.speed_min_mps - deeper_m())
    return drive_to(-deeper_m(), "parking");
  state_ = State::kLooking;
  since_s_ = stamp_s;
  return look_back(stamp_s);
}

Decision FrameBacking::look_back(double stamp_s) {
  const Pose2 off = FrameBacking::off();
  const std::string why =
      fmt::format("{:.3f} m to the side, {:.2f} degrees turned", off.y, to_degrees(off.theta));
  if (stamp_s - since_s_ < params_.look_s) return {.state = "looking", .why = why};
  const bool is_good =
      std::abs(off.y) <= params_.lateral_max_m && std::abs(off.theta) <= params_.turned_max_rad;
  const bool stays = is_good || tries_ >= params_.tries_max;
  if (!stays) ++tries_;
  state_ = stays ? State::kComingForward : State::kLeaving;
  return {.state = stays ? "parking" : "driving out", .why = why};
}

Decision FrameBacking::come_forward() {
  if (off().x < -vehicle_.cycle_s * params_.speed.speed_min_mps) return drive_to(0, "parking");
  const Pose2 off = FrameBacking::off();
  return {.status = NavigatorStatus::kDone,
          .state = "parked",
          .why = fmt::format("{:.3f} m to the side, {:.2f} degrees turned", off.y, to_degrees(off.theta))};
}

Decision FrameBacking::leave() {
  if (off().x < run_up_m_) return drive_to(run_up_m_, "driving out");
  state_ = State::kBackingIn;
  return {.state = "parking"};
}

}  // namespace aisle
