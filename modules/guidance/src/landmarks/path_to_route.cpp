#include "aisle/guidance/landmarks/path_to_route.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kRoutePlacesApart_m = 0.1;    // between goal poses along the route, which are ...
constexpr double kReached_m = 12;              // ... at most this far from the vehicle
constexpr double kOnRoute_m = 0.2;             // within this distance ...
constexpr double kOnRoute_rad = 12 * kDegree;  // ... and yaw error, the steering does the rest
constexpr int kExpansions = 1500;              // of the path search, per cycle

}  // namespace

PathToRoute::PathToRoute(const VehicleDescription& vehicle, const SteeringParams& steering,
                         const SpeedParams& speed, const KnownFloor& floor)
    : floor_(floor), search_({}, vehicle), driver_(vehicle, steering, speed) {}

void PathToRoute::begin(const Path& route, const Pose2& T_map_floor, const Pose2& T_map_vehicle) {
  T_floor_map_ = T_map_floor.inverse();
  T_floor_route_.clear();
  const auto places = static_cast<int>(std::ceil(route.length_m() / kRoutePlacesApart_m));
  for (int i = 0; i < places; ++i) {
    const Pose2 T_map_route = route.at(i * kRoutePlacesApart_m).T_map_path;
    if ((T_map_route.position() - T_map_vehicle.position()).norm() < kReached_m)
      T_floor_route_.push_back(T_floor_map_ * T_map_route);
  }
  search_.look_for(
      T_floor_map_ * T_map_vehicle, [this](const Pose2& T_floor) { return is_on_route(T_floor); },
      [this](const Vec2& p_floor) { return left_m(p_floor); });
  state_ = T_floor_route_.empty() ? State::kNoPath : State::kSearching;
}

PathToRoute::State PathToRoute::step(const Pose2& T_map_vehicle, double steering_rad, Command& command) {
  command = {.steering_rad = steering_rad};
  if (state_ == State::kSearching) state_ = search();
  if (state_ != State::kDriving) return state_;
  const PathDriver::Step step =
      driver_.drive(floor_, search_.footprint_clearance(), T_floor_map_ * T_map_vehicle, steering_rad);
  command = step.command;
  if (step.state == PathDriver::State::kArrived) state_ = State::kThere;
  if (step.state == PathDriver::State::kBlocked) state_ = State::kNoPath;
  return state_;
}

PathAhead PathToRoute::ahead(const Pose2& T_map_vehicle, double reach_m) const {
  if (!driver_.has_path()) return {};
  const Path& path = driver_.path();
  return path_ahead(path, path.at(path.length_m() - driver_.left_m()), T_floor_map_ * T_map_vehicle, reach_m);
}

PathToRoute::State PathToRoute::search() {
  switch (search_.advance(floor_, kExpansions)) {
    case CarSearch::State::kFound: {
      const Path path = search_.path();
      if (path.empty()) return State::kThere;
      driver_.take(path);
      return State::kDriving;
    }
    case CarSearch::State::kNone:
      return State::kNoPath;
    case CarSearch::State::kIdle:
    case CarSearch::State::kSearching:
      break;
  }
  return State::kSearching;
}

bool PathToRoute::is_on_route(const Pose2& T_floor_vehicle) const {
  return std::any_of(T_floor_route_.begin(), T_floor_route_.end(), [&](const Pose2& T_floor) {
    const Pose2 off = between(T_floor, T_floor_vehicle);
    return off.position().norm() < kOnRoute_m && std::abs(off.theta) < kOnRoute_rad;
  });
}

double PathToRoute::left_m(const Vec2& p_floor) const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Pose2& T_floor : T_floor_route_)
    least_m = std::min(least_m, (T_floor.position() - p_floor).norm());
  return std::max(0.0, least_m - kOnRoute_m);
}

}  // namespace aisle
