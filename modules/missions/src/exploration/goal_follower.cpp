#include "aisle/missions/exploration/goal_follower.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr int kScansOfCheck = 10;
// As a person points at a map on a screen.
constexpr double kPointing_m = 0.3;
constexpr double kPointing_rad = 10 * kDegree;

std::string text_of(const Vec2& p) {
  return fmt::format("{:.2f}, {:.2f}", p.x(), p.y());
}
std::string text_of(const Pose2& T) {
  return fmt::format("{:.2f}, {:.2f}, {:.0f} deg", T.x, T.y, to_degrees(T.theta));
}
std::string text_of(const GoalPlace& goal) {
  const Vec2& p = goal.p_map;
  return goal.heading_rad ? text_of(Pose2{p.x(), p.y(), *goal.heading_rad}) : text_of(p);
}

}  // namespace

Result<std::unique_ptr<GoalFollower>> GoalFollower::make(const GuideNavigatorParams& params,
                                                         const std::string& building,
                                                         const VehicleDescription& vehicle,
                                                         GoalRequests requests) {
  auto parsed = parse_building(building, "building");
  if (!parsed) return parsed.problems();
  if (Problems problems = check_guidable(*parsed, vehicle); !problems.empty()) return problems;
  return std::make_unique<GoalFollower>(params, vehicle, std::move(*parsed), std::move(requests));
}

GoalFollower::GoalFollower(const GuideNavigatorParams& params, const VehicleDescription& vehicle,
                           Building building, GoalRequests requests)
    : params_(params),
      vehicle_(vehicle),
      building_(std::move(building)),
      requests_(std::move(requests)),
      navigator_(params, vehicle, building_, home_of(building_), {}, scanner_scans(vehicle)),
      sensor_(scanner_scans(vehicle)) {}

Decision GoalFollower::step(const Observation& observation) {
  if (const auto T_map_stated = requests_.initial_pose()) begin_check(*T_map_stated);
  if (const auto goal = requests_.goal()) take_goal(*goal, observation.stamp_s);
  Decision decision = navigator_.step(observation);
  if (check_) {
    check_pose(observation);
    return {.state = "looking"};
  }
  if (!goal_) return {.state = "waiting"};
  if (decision.status == NavigatorStatus::kGoing) return decision;
  if (decision.status == NavigatorStatus::kFailed) return waiting(decision.why);
  ++reached_;
  return waiting(decision.why.empty() ? "arrived" : "arrived, but " + decision.why);
}

bool GoalFollower::is_free(const Vec2& p_map) const {
  return building_.floor->at(p_map) == Floor::kFree;
}

void GoalFollower::take_goal(const GoalPlace& goal, double stamp_s) {
  if (!is_free(goal.p_map))
    return requests_.say(fmt::format("goal {} refused: no free floor is known there", text_of(goal.p_map)));
  ++goals_;
  requests_.say("drives to " + text_of(goal));
  goal_ = goal;
  navigator_.send_to({goal}, stamp_s);
}

void GoalFollower::begin_check(const Pose2& T_map_stated) {
  if (!is_free(T_map_stated.position()))
    return requests_.say(
        fmt::format("initial pose {} refused: no free floor is known there", text_of(T_map_stated)));
  const Vec3 sigma(kPointing_m, kPointing_m, kPointing_rad);
  const UncertainPose2 about_it{T_map_stated, sigma.cwiseAbs2().asDiagonal()};
  check_ = PoseCheck{
      T_map_stated,
      std::make_unique<WallLocaliser>(params_.localiser, sensor_->scanner(), building_.walls, about_it),
      {}};
}

/// The vehicle stands meanwhile.
void GoalFollower::check_pose(const Observation& observation) {
  check_->T_scan_vehicle = check_->T_scan_vehicle * odometry_step(vehicle_, observation.odometry);
  ScanView view;
  if (!sensor_->look(observation, view)) return;
  check_->localiser->take_scan(view.ranges_m, std::exchange(check_->T_scan_vehicle, {}));
  if (++check_->scans < kScansOfCheck) return;
  const PoseCheck check = std::move(*check_);
  check_.reset();
  const std::string fit = fmt::format("{:.1f} of {:.1f} m of the walls in sight fit the map there",
                                      check.localiser->fitting_m(), check.localiser->seen_m());
  if (check.localiser->is_doubtful())
    return requests_.say(fmt::format("initial pose {} refused: {}", text_of(check.T_map_stated), fit));
  const Pose2& T_map_vehicle = check.localiser->T_map_vehicle().mean;
  requests_.say(fmt::format("stands at {}: {}", text_of(T_map_vehicle), fit));
  navigator_.relocate(T_map_vehicle, observation.stamp_s);
}

Decision GoalFollower::waiting(const std::string& because) {
  requests_.say(fmt::format("goal {}: {}; waits for the next one", text_of(goal_->p_map), because));
  goal_.reset();
  return {.state = "waiting"};
}

}  // namespace aisle
