#include "aisle/guidance/sections/section_navigator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kHomeward_m = 2.5;  // the last metres of the way home

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
  fields.flag("guarded", guarded, "stop for what stands in the way, and while the camera shows nothing new");
  fields.real("look_s", look_s, {0, 60},
              "time to look where it stands before it starts, and where it has arrived");
  localiser.describe(fields);
  fields.real("lost_m", lost_m, {0.01, 10}, "less sure how far aside of its way it is, it gives up");
}

SectionNavigator::SectionNavigator(const SectionNavigatorParams& params, const VehicleDescription& vehicle,
                                   const std::string& camera, SectionList sections, GuidedPath way)
    : params_(params),
      vehicle_(vehicle),
      camera_(camera),
      sections_(std::move(sections)),
      way_(std::move(way)),
      detector_(params.floor_edges, named_camera(vehicle, camera).intrinsics,
                named_camera(vehicle, camera).mount),
      localiser_(params.localiser, vehicle, way_),
      follower_(vehicle, params.steering),
      progress_(way_.path),
      guard_(vehicle, params.guard, &named_camera(vehicle, camera)) {}

Decision SectionNavigator::step(const Observation& observation) {
  if (!begun_s_) begun_s_ = observation.stamp_s;
  locate(observation);
  if (observation.bumper_pressed) return fail("bumped", "the bumper is pressed");
  if (observation.stamp_s - *begun_s_ < params_.look_s) return {.state = "looking"};
  const PathPoint& point = progress_.advance(pose_on_way());
  if (progress_.has_arrived()) return take_last_heading(observation.stamp_s);
  const double aside_sigma_m = localiser_.aside_sigma_m(point.T_map_path.theta);
  if (aside_sigma_m > params_.lost_m)
    return fail("lost", fmt::format("saw no base line until unsure by {:.2f} m", aside_sigma_m));
  const double speed_mps = speed_along(way_.path, point.along_m, 1, vehicle_, params_.speed);
  return guarded({.command = follower_.follow(way_.path, point, pose_on_way(), speed_mps, 0),
                  .state = is_guided_ ? "following" : "reckoning",
                  .why = place()});
}

/// Odometry, then the picture.
void SectionNavigator::locate(const Observation& observation) {
  localiser_.predict(observation.odometry);
  is_guided_ = false;
  const CameraPicture* picture = guard_.look(observation);
  if (picture == nullptr || picture != present_picture(observation, camera_, vehicle_.cycle_s)) return;
  edges_ = detector_.detect(*picture->image);
  edges_on_floor_.clear();
  for (const FloorEdge& edge : edges_) edges_on_floor_.push_back(edge.on_floor);
  guard_.see_floor(edges_on_floor_);
  localiser_.correct(edges_on_floor_, progress_.point().piece);
  is_guided_ = localiser_.is_guided();
}

/// Against the way, whose last metres home, and the turn about there, are where the vehicle was set down.
Pose2 SectionNavigator::pose_on_way() const {
  const PathPoint& point = progress_.point();
  const bool is_homeward = way_.comes_home && point.piece + 2 >= way_.path.pieces().size();
  if (!is_homeward || way_.path.length_m() - point.along_m > kHomeward_m) return pose();
  const Vec2 home_off = localiser_.start_pose().position() - way_.path.at(0).T_map_path.position();
  const Vec2 p_way = pose().position() - home_off;
  return {p_way.x(), p_way.y(), pose().theta};
}

/// To the nearest step of a wheel: of less the vehicle does not know. What it sees where it has arrived may
/// still tell that it is headed otherwise.
Decision SectionNavigator::take_last_heading(double stamp_s) {
  const double step_rad = vehicle_.differential.step_length_m() / vehicle_.differential.wheel_separation_m;
  const double way_rad = way_.path.pieces().back().end().theta;
  const double askew_rad = localiser_.start_pose().theta - way_.path.at(0).T_map_path.theta;
  const double due_rad = wrap_angle(way_rad + (way_.comes_home ? askew_rad : 0));
  if (std::abs(wrap_angle(due_rad - pose().theta)) >= step_rad) {
    headed_s_.reset();
    return guarded({.command = follower_.turn_to(due_rad, pose().theta), .state = "turning", .why = place()});
  }
  if (!headed_s_) headed_s_ = stamp_s;
  if (stamp_s - *headed_s_ < params_.look_s) return {.state = "looking", .why = place()};
  return {.status = NavigatorStatus::kDone, .state = "arrived"};
}

/// The same as far as nothing stands in the way.
Decision SectionNavigator::guarded(Decision decision) {
  if (!params_.guarded) return decision;
  const WayAhead way = way_ahead(way_.path, progress_.point(), pose_on_way(), params_.guard.reach_m);
  const Guarded allowed = guard_.allow(decision.command, way);
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
