#include "aisle/guidance/guide_navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kWatchShare = 0.4;     // of the margin that a way must keep while it is driven
constexpr double kSpareNoise_m = 0.02;  // of the room that the vehicle seems to have
constexpr double kWatchAhead_m = 1.5;
constexpr double kWatchEvery_m = 0.1;
constexpr double kGetsOn_m = 0.3;     // within the time after which it gives up
constexpr double kSearchAgain_s = 2;  // after there was no way

UncertainPose2 about_start(const Pose2& T_map_start, const GuideNavigatorParams& params) {
  const Vec3 sigma(params.start_sigma_m, params.start_sigma_m, params.start_sigma_rad);
  return {T_map_start, sigma.cwiseAbs2().asDiagonal()};
}

const FloorGrid& floor_of(const Building& building) {
  if (!building.floor) throw std::invalid_argument("a building to be guided in needs its floor");
  return *building.floor;
}

}  // namespace

void GuideNavigatorParams::describe(FieldList& fields) {
  fields.group("localiser", localiser);
  fields.group("view", view);
  fields.group("legs", legs);
  fields.group("search", search);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.real("start_sigma_m", start_sigma_m, {0.001, 2}, "how far off its start the vehicle may stand");
  fields.angle("start_sigma_deg", start_sigma_rad, {0.05, 30}, "how far it may be turned there");
  fields.real("look_s", look_s, {0, 60}, "time to look around before it starts");
  fields.real("look_every_m", look_every_m, {0.02, 2}, "way after which the floor is looked at again");
  fields.real("look_every_s", look_every_s, {0.05, 10}, "time after which it is");
  fields.real("arrive_m", arrive_m, {0.05, 3}, "so near the vehicle has reached a place");
  fields.real("lost_s", lost_s, {0.5, 60}, "seeing other walls than are known for so long it is lost");
  fields.real("give_up_s", give_up_s, {1, 3600}, "without any way for so long it gives up");
  fields.count("expansions", expansions, {10, 100000}, "poses that the search looks at in a cycle");
}

GuideNavigator::GuideNavigator(const GuideNavigatorParams& params, const VehicleDescription& vehicle,
                               const Building& building, const Pose2& T_map_start,
                               std::vector<Vec2> p_map_places, std::unique_ptr<SliceSensor> sensor)
    : params_(params),
      vehicle_(vehicle),
      sensor_(std::move(sensor)),
      localiser_(params.localiser, sensor_->fan(), building.walls, about_start(T_map_start, params)),
      floor_(floor_of(building)),
      clearance_(params.legs),
      search_(params.search, vehicle),
      watch_(vehicle.footprint, kWatchShare * params.search.margin_m),
      braking_(vehicle, kWatchShare * params.search.margin_m),
      follower_(vehicle, params.steering),
      p_map_places_(std::move(p_map_places)),
      T_map_vehicle_(T_map_start) {
  clearance_.update(floor_, floor_.known());
}

Decision GuideNavigator::step(const Observation& observation) {
  const double stamp_s = observation.stamp_s;
  if (!begun_s_) begun_s_ = sure_s_ = hopeful_s_ = stamp_s;
  locate(observation);
  if (const std::string why = why_failed(observation); !why.empty())
    return {.status = NavigatorStatus::kFailed, .state = "given up", .why = why};
  if (stamp_s - *begun_s_ < params_.look_s) return {.state = "looking"};
  check_way();
  if (next_ < p_map_places_.size()) search_way(stamp_s);
  if (next_ == p_map_places_.size()) return {.status = NavigatorStatus::kDone, .state = "arrived"};
  return drive(observation);
}

void GuideNavigator::locate(const Observation& observation) {
  T_scan_vehicle_ = T_scan_vehicle_ * odometry_step(vehicle_, observation.odometry);
  const bool sees = sensor_->look(observation, view_);
  if (sees) localiser_.take_scan(view_.ranges_m, std::exchange(T_scan_vehicle_, {}));
  T_map_vehicle_ = localiser_.T_map_vehicle().mean * T_scan_vehicle_;
  if (!localiser_.is_doubtful()) sure_s_ = observation.stamp_s;
  if (sees && !localiser_.is_doubtful()) look_at_floor(observation.stamp_s);
}

void GuideNavigator::look_at_floor(double stamp_s) {
  const bool moved = between(T_map_looked_, T_map_vehicle_).position().norm() >= params_.look_every_m;
  if (!moved && stamp_s - looked_s_ < params_.look_every_s) return;
  looked_s_ = stamp_s;
  T_map_looked_ = T_map_vehicle_;
  FloorBox changed =
      see_floor(floor_, sensor_->fan(), view_.ranges_m, view_.near_m, T_map_vehicle_, params_.view);
  const FloorBox stood = stand_on_floor(floor_, vehicle_.footprint, T_map_vehicle_);
  if (!stood.empty()) {
    changed.include(stood.low);
    changed.include({stood.end.x - 1, stood.end.y - 1});
  }
  clearance_.update(floor_, changed);
}

std::string GuideNavigator::why_failed(const Observation& observation) {
  if (observation.bumper_pressed) return "the bumper is pressed";
  if (observation.stamp_s - sure_s_ > params_.lost_s) return "lost: what it sees fits no walls that it knows";
  if (observation.stamp_s - hopeful_s_ <= params_.give_up_s) return "";
  const Vec2& p = p_map_places_[next_];
  return fmt::format("there is no way to {:.1f}, {:.1f}", p.x(), p.y());
}

/// Something may have come into the way, or the vehicle may have strayed from it. Where it has less room
/// already than it should, only still less is worse.
void GuideNavigator::check_way() {
  if (!progress_) return;
  const double spare_min_m = std::min(0.0, room_at(T_map_vehicle_)) - kSpareNoise_m;
  const double along_m = progress_->point().along_m;
  for (double ahead_m = 0; ahead_m <= kWatchAhead_m && along_m + ahead_m < path_.length_m();
       ahead_m += kWatchEvery_m) {
    if (room_at(path_.at(along_m + ahead_m).T_map_path) >= spare_min_m) continue;
    ++ways_closed_;
    return drop_way();
  }
}

double GuideNavigator::room_at(const Pose2& T_map_vehicle) const {
  return watch_.spare_m(floor_, clearance_, T_map_vehicle);
}

void GuideNavigator::drop_way() {
  progress_.reset();
  path_ = {};
  search_.stop();
}

bool GuideNavigator::is_at_place(const Pose2& T_map_vehicle) const {
  const Footprint& footprint = vehicle_.footprint;
  const Segment2 axis{T_map_vehicle * Vec2(-footprint.rear_m, 0), T_map_vehicle * Vec2(footprint.front_m, 0)};
  return axis.distance(p_map_places_[next_]) <= params_.arrive_m;
}

void GuideNavigator::begin_search() {
  const Vec2& p_map_place = p_map_places_[next_];
  search_.look_for(floor_, clearance_, T_map_vehicle_, p_map_place, vehicle_.footprint.front_m,
                   [this](const Pose2& T_map) { return is_at_place(T_map); });
}

void GuideNavigator::search_way(double stamp_s) {
  if ((T_map_vehicle_.position() - p_map_hopeful_).norm() > kGetsOn_m) {
    hopeful_s_ = stamp_s;
    p_map_hopeful_ = T_map_vehicle_.position();
  }
  if (progress_) return;
  if (search_.state() == CarSearch::State::kIdle) begin_search();
  if (search_.state() == CarSearch::State::kNone) {
    if (stamp_s - searched_s_ < kSearchAgain_s) return;
    begin_search();
  }
  const CarSearch::State state = search_.advance(floor_, clearance_, params_.expansions);
  if (state == CarSearch::State::kNone) searched_s_ = stamp_s;
  if (state != CarSearch::State::kFound) return;
  path_ = search_.path();
  search_.stop();
  if (path_.empty()) {
    ++next_;
    hopeful_s_ = stamp_s;
  } else {
    progress_.emplace(path_);
  }
}

Decision GuideNavigator::drive(const Observation& observation) {
  const double steering_rad = steering_rad_of(observation.odometry);
  Decision standing{.command = {.steering_rad = steering_rad}, .state = "searching"};
  if (!progress_) return standing;
  const PathPoint& point = progress_->advance(T_map_vehicle_);
  if (progress_->has_arrived()) {
    drop_way();
    return standing;
  }
  const double care = driving_care(vehicle_, watch_, floor_, clearance_, path_, point.along_m, steering_rad);
  const double speed_mps = speed_along(path_, point.along_m, care, vehicle_, params_.speed);
  const Command command = follower_.follow(path_, point, T_map_vehicle_, speed_mps, steering_rad);
  braking_.see(sensor_->fan(), view_.ranges_m);
  if (!braking_.is_free(floor_, clearance_, T_map_vehicle_, command, steering_rad)) {
    drop_way();
    return standing;
  }
  return {.command = command, .state = "driving"};
}

}  // namespace aisle
