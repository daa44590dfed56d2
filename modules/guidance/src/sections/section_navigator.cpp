#include "aisle/guidance/sections/section_navigator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kHomeward_m = 2.5;  // the last metres of the path home

const CameraDescription& named_camera(const VehicleDescription& vehicle, const std::string& name) {
  if (const CameraDescription* camera = vehicle.camera(name)) return *camera;
  throw std::invalid_argument("the vehicle lacks the camera that is to look along the corridor");
}

}  // namespace

void SectionNavigatorParams::describe(FieldList& fields) {
  fields.group("floor_edges", floor_edges);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.group("guard", guard);
  fields.flag("guarded", guarded, "stop for obstacles in the path, and while the camera fails");
  fields.real("look_s", look_s, {0, 60},
              "time to look where it stands before it starts, and where it has arrived");
  localiser.describe(fields);
  fields.real("lost_m", lost_m, {0.01, 10}, "lateral uncertainty above which it gives up");
}

SectionNavigator::SectionNavigator(const SectionNavigatorParams& params, const VehicleDescription& vehicle,
                                   const std::string& camera, SectionList sections, GuidedPath guided,
                                   FloorRules rules)
    : params_(params),
      vehicle_(vehicle),
      camera_(camera),
      sections_(std::move(sections)),
      guided_(std::move(guided)),
      detector_(params.floor_edges, named_camera(vehicle, camera).intrinsics,
                named_camera(vehicle, camera).mount),
      localiser_(params.localiser, vehicle, guided_),
      follower_(vehicle, params.steering),
      progress_(guided_.path),
      guard_(vehicle, params.guard, &named_camera(vehicle, camera)),
      rules_(std::move(rules)) {}

Decision SectionNavigator::step(const Observation& observation) {
  return rules_.obey(decide(observation), pose());
}

Decision SectionNavigator::decide(const Observation& observation) {
  if (!begun_s_) begun_s_ = observation.stamp_s;
  locate(observation);
  if (observation.bumper_pressed) return fail("bumped", "the bumper is pressed");
  if (observation.stamp_s - *begun_s_ < params_.look_s) return {.state = "looking"};
  const PathPoint& point = progress_.advance(pose_on_path());
  if (progress_.has_arrived()) return take_last_heading(observation.stamp_s);
  const double lateral_sigma_m = localiser_.lateral_sigma_m(point.T_map_path.theta);
  if (lateral_sigma_m > params_.lost_m)
    return fail("lost", fmt::format("saw no base line until its lateral position was uncertain by {:.2f} m",
                                    lateral_sigma_m));
  const double speed_mps = speed_along(guided_.path, point.along_m, 1, vehicle_, params_.speed);
  return guarded({.command = follower_.follow(guided_.path, point, pose_on_path(), speed_mps, 0),
                  .state = is_guided_ ? "following" : "reckoning",
                  .why = place()});
}

/// Updates the pose by odometry, then by the image.
void SectionNavigator::locate(const Observation& observation) {
  localiser_.predict(observation.odometry);
  is_guided_ = false;
  const CameraImage* image = guard_.look(observation);
  if (image == nullptr || !localiser_.go_back(guard_.odometry().cycles_since(image->stamp_s))) return;
  edges_ = detector_.detect(*image->pixels);
  edges_on_floor_.clear();
  for (const FloorEdge& edge : edges_) edges_on_floor_.push_back(edge.on_floor);
  guard_.see_floor(edges_on_floor_, image->stamp_s);
  localiser_.correct(edges_on_floor_, progress_.point().piece);
  localiser_.catch_up();
  is_guided_ = localiser_.is_guided();
}

/// The pose relative to the path. The last metres home, and the turn about there, are shifted to where the
/// vehicle really started.
Pose2 SectionNavigator::pose_on_path() const {
  const PathPoint& point = progress_.point();
  const bool is_homeward = guided_.comes_home && point.piece + 2 >= guided_.path.pieces().size();
  if (!is_homeward || guided_.path.length_m() - point.along_m > kHomeward_m) return pose();
  const Vec2 home_off = localiser_.start_pose().position() - guided_.path.at(0).T_map_path.position();
  const Vec2 p_path = pose().position() - home_off;
  return {p_path.x(), p_path.y(), pose().theta};
}

/// Turns to the final heading, to the resolution of the wheel steps. What it sees after arriving may still
/// correct its heading.
Decision SectionNavigator::take_last_heading(double stamp_s) {
  const double step_rad = vehicle_.differential.step_length_m() / vehicle_.differential.wheel_separation_m;
  const double path_rad = guided_.path.end().theta;
  const double yaw_error_rad = localiser_.start_pose().theta - guided_.path.at(0).T_map_path.theta;
  const double due_rad = wrap_angle(path_rad + (guided_.comes_home ? yaw_error_rad : 0));
  if (std::abs(wrap_angle(due_rad - pose().theta)) >= step_rad) {
    headed_s_.reset();
    return guarded({.command = follower_.turn_to(due_rad, pose().theta), .state = "turning", .why = place()});
  }
  if (!headed_s_) headed_s_ = stamp_s;
  if (stamp_s - *headed_s_ < params_.look_s) return {.state = "looking", .why = place()};
  return {.status = NavigatorStatus::kDone, .state = "arrived"};
}

/// The decision, limited by obstacles.
Decision SectionNavigator::guarded(Decision decision) {
  if (!params_.guarded) return decision;
  const PathAhead guided = path_ahead(guided_.path, progress_.point(), pose_on_path(), params_.guard.reach_m);
  const Guarded allowed = guard_.allow(decision.command, guided);
  if (allowed.state == GuardState::kBlocked) return fail("blocked", allowed.why);
  decision.command = allowed.command;
  if (allowed.state == GuardState::kWaiting) decision.state = "waiting";
  if (!allowed.why.empty()) decision.why += ": " + allowed.why;
  return decision;
}

std::string SectionNavigator::place() const {
  return fmt::format("section {} of {}", guide().section + 1, sections_.size());
}

Decision SectionNavigator::fail(std::string state, const std::string& what) const {
  return {.status = NavigatorStatus::kFailed, .state = std::move(state), .why = what + " in " + place()};
}

}  // namespace aisle
