#include "aisle/guidance/rooms/room_navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/core/square.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/guidance/rooms/route_floor.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

Route room_route(Route route) {
  if (!route.room || route.path.empty()) throw std::invalid_argument("the route was not taught in a room");
  return route;
}

RouteView first_view(const RoomNavigatorParams& params, const VehicleDescription& vehicle) {
  const CameraDescription& camera = room_camera(vehicle, kFirstCamera);
  return {params.view,
          camera.intrinsics,
          camera.mount,
          camera.width_px,
          camera.height_px,
          vehicle.footprint.width_m,
          stripe_height_m(vehicle)};
}

/// The first piece of the leg that a piece belongs to.
std::size_t leg_begin(const Path& path, std::size_t piece) {
  std::size_t first = piece;
  while (first > 0 && path.leg_end(first - 1) == path.leg_end(piece)) --first;
  return first;
}

}  // namespace

void RoomNavigatorParams::describe(FieldList& fields) {
  fields.group("view", view);
  fields.group("steering", steering);
  fields.group("images", images);
  fields.group("corner_backing", corner_backing);
  fields.group("frame", frame);
  fields.group("frame_backing", frame_backing);
  fields.group("stop_views", stop_views);
  fields.group("place", place);
  fields.group("taught_place", taught_place);
  fields.real("speed_mps", speed_mps, {0.02, 2}, "between turnings");
  fields.real("turning_speed_mps", turning_speed_mps, {0.02, 2}, "in turnings");
  fields.real("parking_speed_mps", parking_speed_mps, {0.02, 2}, "near the end");
  fields.real("look_ahead_m", look_ahead_m, {0.2, 5},
              "distance to the point of the taught path that it steers to");
  fields.real("middle_share", middle_share, {0, 1},
              "weight of the route's middle against the taught path; 1: as published");
  fields.real("turning_middle_share", turning_middle_share, {0, 1}, "the same in turnings");
  fields.real("place_from_m", place_from_m, {0, 1000},
              "distance to the end from which it localises by the edges");
  fields.real("taught_alone_m", taught_alone_m, {0, 20},
              "distance to the end from which only the taught path counts");
  fields.real("end_comfort_m", end_comfort_m, {0.01, 2}, "clearance that it tries to keep there");
  fields.angle("avoid_deg", avoid_rad, {0, 60}, "steering angle away from an obstacle that is too near");
  fields.flag("avoid_as_published", avoid_as_published, "by the three check regions, before all else");
  fields.real("dead_end_share", dead_end_share, {0, 1}, "a view with less share of route is a dead end");
  fields.real("dead_end_gap_m", dead_end_gap_m, {0, 3}, "gap to a dead end at which it stops");
  fields.count("dead_end_images", dead_end_images, {1, 100}, "images in a row that must show a dead end");
  fields.real("dead_end_beyond_m", dead_end_beyond_m, {0, 3},
              "path beyond the taught dead end after which it gives up");
  fields.real("frame_within_m", frame_within_m, {0.5, 20},
              "distance to the end from which it looks for the frame");
  fields.real("frame_astray_m", frame_astray_m, {0.05, 20},
              "a frame first seen farther from the taught one is ignored once the edges have localised it");
  fields.real("brightness_tolerance", brightness_tolerance, {0.01, 1},
              "share by which the route may suddenly look brighter or darker");
  fields.real("brightness_gain", brightness_gain, {0, 1},
              "how fast the learned brightness follows the light");
  fields.real("hidden_max_m", hidden_max_m, {0, 10},
              "path that it drives from memory while an obstacle ahead hides the route");
  fields.real("stop_free_m", stop_free_m, {0.01, 2}, "with less free path it stops");
  fields.real("wait_s", wait_s, {0, 100}, "time to wait for an obstacle in the path to leave");
  fields.real("back_off_m", back_off_m, {0.05, 5}, "path back before it tries again");
  fields.count("back_offs_max", back_offs_max, {0, 100}, "times to back off at one place before it gives up");
  fields.real("pattern_share_max", pattern_share_max, {0, 1},
              "share of the taught path with edges on it above which the floor counts as patterned");
  fields.real("blind_max_s", blind_max_s, {0.5, 1000}, "without a good image for this long it gives up");
}

RoomNavigator::RoomNavigator(const RoomNavigatorParams& params, const VehicleDescription& vehicle,
                             Route route, double from_m, FloorRules rules)
    : params_(params),
      vehicle_(vehicle),
      route_(room_route(std::move(route))),
      view_(first_view(params, vehicle)),
      calibration_(vehicle.front_steered),
      odometry_(vehicle, route_.path.at(from_m).T_map_path),
      monitor_(params.images, room_camera(vehicle, kFirstCamera)),
      edges_(kReach_m),
      place_(params.place, route_.room->edges),
      progress_(route_.path, from_m),
      stop_views_(params.stop_views, route_.room->views),
      brightness_(route_.room->brightness),
      T_odom_seen_(odometry_.T_odom_vehicle()),
      taught_place_(params.taught_place, vehicle, route_.path),
      pattern_share_(share_with_edges_on_path(route_.path, route_.room->edges, vehicle.footprint)),
      rules_(std::move(rules)) {
  if (backs_between_turnings(route_))
    corner_backing_ = std::make_unique<CornerBacking>(params.corner_backing, params.view, vehicle);
  if (route_.room->parking != ParkingStrategy::kFrame) return;
  frame_ = std::make_unique<FrameParking>(params.frame, vehicle, route_.room->frame_size_m);
  if (params.frame_backing.wanted) {
    frame_backing_ = std::make_unique<FrameBacking>(params.frame_backing, vehicle, route_.room->frame_size_m);
  }
}

Decision RoomNavigator::step(const Observation& observation) {
  Decision decision = rules_.obey(decide(observation), pose());
  decision.command.steering_rad -= calibration_.correction().steering_bias_rad;
  commanded_mps_ = decision.command.speed_mps;
  return decision;
}

Decision RoomNavigator::decide(const Observation& observation) {
  odometry_.move(observation);
  if (const auto* reported = std::get_if<FrontSteeredMotion>(&observation.odometry))
    calibration_.move(observation.stamp_s, *reported, commanded_mps_ * vehicle_.cycle_s);
  steering_rad_ = steering_rad_of(observation.odometry) + calibration_.correction().steering_bias_rad;
  remember_driven();
  if (state_ != State::kBackingOff) progress_.advance(pose());
  look(observation);
  if (observation.bumper_pressed)
    return {.status = NavigatorStatus::kFailed, .state = "bumped", .why = "the bumper is pressed"};
  if (!calibration_.is_plausible()) return slipping();
  if (const auto trouble = monitor_.trouble(observation.stamp_s); trouble || !sight()) {
    if (!blind_s_) blind_s_ = observation.stamp_s;
    const bool is_lasting = observation.stamp_s - *blind_s_ > params_.blind_max_s;
    return {.status = is_lasting ? NavigatorStatus::kFailed : NavigatorStatus::kGoing,
            .state = "blind",
            .why = trouble.value_or("no image yet")};
  }
  blind_s_.reset();
  if (frame_ && left_m() < params_.frame_within_m) look_for_frame(observation);
  if (state_ == State::kParkingInFrame) return park_in_frame(observation.stamp_s);
  if (state_ == State::kBackingIntoFrame) return back_into_frame(observation.stamp_s);
  if (state_ == State::kBackingOff) return back_off(observation.stamp_s);
  if (state_ == State::kLeavingPlace) return leave_place();
  if (state_ == State::kFollowing && is_on_path_back()) begin_path_back();
  if (state_ == State::kBackingBetweenTurnings) {
    corner_backing_->look(observation, T_odom_vehicle());
    return back_between_turnings();
  }
  return follow(observation.stamp_s);
}

void RoomNavigator::look(const Observation& observation) {
  const CameraImage* image = monitor_.look(observation, odometry_);
  if (image == nullptr) return;
  const RouteSight& sight = view_.look(*image->pixels);
  stop_views_.take(*image->pixels, left_to_end_m());
  is_brightness_off_ = std::abs(relative_brightness() - 1) > params_.brightness_tolerance;
  dead_end_images_ = is_at_dead_end() ? dead_end_images_ + 1 : 0;
  if (is_brightness_off_) return;
  // Near the end taught edges tell the pose, and table tops and painted lines are among what is seen.
  if (!place_.is_sure()) calibrate(image->stamp_s);
  T_odom_seen_ = odometry_.T_odom_at(image->stamp_s);
  // Beyond L96: the learned brightness follows slow changes of light.
  brightness_.grey += params_.brightness_gain * (sight.patch_grey - brightness_.grey);
  edges_.take(view_, sight, T_odom_seen_, image->stamp_s);
  find_place();
}

/// What is remembered of the last metre moves along with its odometry.
void RoomNavigator::calibrate(double stamp_s) {
  const OdometryCorrection error = calibration_.correction();
  calibration_.look(stamp_s, sight()->p_vehicle_edges);
  if (calibration_.correction() == error) return;
  const OdometryHistory before = odometry_;
  odometry_.correct(calibration_.correction(), calibration_.correction_from_s());
  edges_.correct(before, odometry_);
  place_.correct(before.T_odom_vehicle(), odometry_.T_odom_vehicle());
}

/// Of the route before the vehicle, as a multiple of what was learned.
double RoomNavigator::relative_brightness() const {
  return sight()->patch_grey / std::max(1.0, brightness_.grey);
}

/// A known obstacle ahead may hide the route, as in a narrow turning. That says nothing about the light, and
/// the vehicle remembers where the path leads.
bool RoomNavigator::knows_path_ahead() const {
  if (!is_brightness_off_) return true;
  const std::vector<Vec2> around = edges_.around(T_odom_vehicle());
  const bool is_hidden =
      std::any_of(around.begin(), around.end(), [&](const Vec2& p) { return view_.is_before_patch_end(p); });
  return is_hidden && between(T_odom_seen_, T_odom_vehicle()).position().norm() < params_.hidden_max_m;
}

/// Near the end of its path, also if it started there, the vehicle knows its pose roughly, and the edges
/// improve it. Farther from the end, objects that were moved since teaching would do more harm.
void RoomNavigator::find_place() {
  place_.come_to(T_odom_vehicle(), progress_.point().along_m);
  if (left_m() > params_.place_from_m) return;
  constexpr double kAbout_m = 1;
  const bool was_sure = place_.is_sure();
  const double along_m = progress_.point().along_m;
  place_.take(edges_.seen_around(T_odom_vehicle()), T_odom_vehicle(), along_m);
  if (was_sure || !place_.is_sure()) return;
  const std::size_t piece = progress_.point().piece;
  const PathPoint there = route_.path.nearest(pose().position(), along_m - kAbout_m, along_m + kAbout_m,
                                              leg_begin(route_.path, piece), route_.path.leg_end(piece));
  progress_ = PathProgress(route_.path, there.along_m);
}

double RoomNavigator::steering_to(const Vec2& p_vehicle) const {
  const double curvature_per_m = 2 * p_vehicle.y() / std::max(p_vehicle.squaredNorm(), 0.01);
  return std::atan(vehicle_.front_steered.wheelbase_m * curvature_per_m);
}

/// L96 section 3.1: steers 30 degrees away from obstacles in the check regions.
std::optional<double> RoomNavigator::avoiding_rad() const {
  const RouteChecks& checks = sight()->checks;
  const bool is_turning = turning_at(route_.room->turnings, progress_.point().along_m) != nullptr;
  if (!params_.avoid_as_published || is_turning || is_brightness_off_) return std::nullopt;
  if (checks.left && !checks.right) return -params_.avoid_rad;
  if (checks.right && !checks.left) return params_.avoid_rad;
  if (checks.ahead) return checks.left_share > checks.right_share ? params_.avoid_rad : -params_.avoid_rad;
  return std::nullopt;
}

bool RoomNavigator::keeps_to_taught_end() const {
  return place_.is_sure() && left_m() < params_.taught_alone_m;
}

double RoomNavigator::requested_steering_rad() const {
  if (keeps_to_taught_end()) {
    return taught_place_.steering_rad(progress_.point(), pose(), params_.parking_speed_mps, steering_rad_);
  }
  const double along_m = progress_.point().along_m;
  const RoomTurning* turning = turning_at(route_.room->turnings, along_m);
  const MaskOut mask = turning != nullptr ? mask_out(*turning, along_m) : MaskOut{};
  const double ahead_m = along_m + params_.look_ahead_m;
  const double leg_end_m = route_.path.leg_end_m(progress_.point().piece);
  const double beyond_m = std::max(0.0, ahead_m - leg_end_m);
  const Vec2 p_map_ahead = route_.path.at(std::min(ahead_m, leg_end_m)).T_map_path * Vec2(beyond_m, 0);
  const double taught_rad = steering_to(pose().inverse() * p_map_ahead);
  const auto middle = is_brightness_off_ ? std::nullopt : view_.middle(*sight(), mask.left, mask.right);
  if (!middle) return taught_rad;
  const bool turns = turning != nullptr && class_of_turning(turning->number) != TurningClass::kStraightOn;
  const double share = turns ? params_.turning_middle_share : params_.middle_share;
  const Vec2 p_vehicle_middle = between(T_odom_vehicle(), T_odom_seen_) * *middle;
  return share * steering_to(p_vehicle_middle) + (1 - share) * taught_rad;
}

Decision RoomNavigator::follow(double now_s) {
  if (auto decision = arrived()) return *decision;
  const std::vector<Vec2> around = edges_.around(T_odom_vehicle());
  const bool is_near_end = left_m() < 1;
  const auto avoiding = is_near_end ? std::nullopt : avoiding_rad();
  const double requested_rad = avoiding.value_or(requested_steering_rad());
  FreeSteeringParams steering = params_.steering;
  if (keeps_to_taught_end()) steering.comfort_m = params_.end_comfort_m;
  const SteeringChoice choice = choose_steering(vehicle_, steering, around, requested_rad);
  const bool is_blocked = !knows_path_ahead() || choice.free_m < params_.stop_free_m;
  if (is_blocked && has_path_back_next()) {
    begin_path_back();
    return {.state = "backing"};
  }
  if (is_blocked) return blocked(now_s);
  stopped_s_.reset();
  const bool is_turning = turning_at(route_.room->turnings, progress_.point().along_m) != nullptr;
  const double speed_mps = is_near_end || is_brightness_off_ ? params_.parking_speed_mps
                           : is_turning                      ? params_.turning_speed_mps
                                                             : params_.speed_mps;
  return drive(choice, speed_mps, avoiding ? "avoiding" : is_turning ? "turning" : "following");
}

Decision RoomNavigator::drive(const SteeringChoice& choice, double speed_mps,
                              const std::string& state) const {
  const double braking_m = std::max(0.0, choice.free_m - params_.stop_free_m / 2);
  const double stoppable_mps = std::sqrt(vehicle_.limits.deceleration_max_mps2 * braking_m);
  return {.command = {.speed_mps = std::min(speed_mps, stoppable_mps), .steering_rad = choice.steering_rad},
          .state = state,
          .why = fmt::format("{:.1f} m to go, {:.2f} m free", std::max(0.0, left_m()), choice.free_m)};
}

std::optional<OdometryCorrection> RoomNavigator::odometry_correction() const {
  return calibration_.has_correction() ? std::optional(calibration_.correction()) : std::nullopt;
}

Decision RoomNavigator::slipping() const {
  return {.status = NavigatorStatus::kFailed,
          .state = "slipping",
          .why = fmt::format("the wheels count {:.1f} times the path that the images show",
                             1 / calibration_.correction().distance_factor)};
}

std::string RoomNavigator::why_waiting() const {
  if (knows_path_ahead()) return "something is in the path";
  return fmt::format("the floor ahead is {:.1f} times as bright as it was taught", relative_brightness());
}

std::string RoomNavigator::why_blocked() const {
  if (!knows_path_ahead()) return why_waiting();
  return pattern_share_ > params_.pattern_share_max
             ? fmt::format(
                   "cannot tell the floor's pattern from what stands on it, as on {:.0f} % of the "
                   "taught path",
                   100 * pattern_share_)
             : "found no path past the obstacle";
}

/// Waits, as a person in the path may leave; then backs off to pass the obstacle on another path.
Decision RoomNavigator::blocked(double now_s) {
  if (!stopped_s_) stopped_s_ = now_s;
  if (now_s - *stopped_s_ < params_.wait_s) return {.state = "waiting", .why = why_waiting()};
  const double along_m = progress_.point().along_m;
  if (along_m > back_offs_at_m_ + 2 * params_.back_off_m) back_offs_ = 0;
  back_offs_at_m_ = along_m;
  if (back_offs_ >= params_.back_offs_max)
    return {.status = NavigatorStatus::kFailed, .state = "blocked", .why = why_blocked()};
  ++back_offs_;
  begin_to_back_off();
  return {.state = "backing off"};
}

}  // namespace aisle
