#include "aisle/guidance/exploration/floor_learner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kSetDownAhead_m = 0.15;
constexpr double kSetDownBeside_m = 0.1;
constexpr double kOutOfPlace_m =
    0.025;                            // the floor is laid again when a scan lies so far from where it was put
constexpr double kLever_m = 2;        // at which turns count
constexpr double kLaidACycle = 8;     // of the scans that are laid again, on cells ...
constexpr double kLaidCell_m = 0.05;  // ... so wide
constexpr double kNearBy_m = 2.5;     // what is hit so near may be in the path soon ...
constexpr double kApart_m = 0.1;      // ... and is new where nothing stands so near to it
constexpr double kStanding_m = 0.002;  // of path in a cycle

}  // namespace

void FloorLearnerParams::describe(FieldList& fields) {
  fields.group("mapping", mapping);
  fields.group("view", view);
  fields.group("legs", legs);
  fields.real("cell_m", cell_m, {0.02, 0.2}, "cells of the floor");
  fields.real("cell_least_m", cell_least_m, {0.02, 0.2},
              "to which they are halved where paths stay out of reach");
  fields.real("look_every_m", look_every_m, {0.02, 2}, "path after which the floor is looked at again");
  fields.angle("look_every_deg", look_every_rad, {0.5, 90}, "turning after which it is");
  fields.count("look_every_cycles", look_every_cycles, {1, 1000}, "cycles after which it is");
}

FloorLearner::FloorLearner(const FloorLearnerParams& params, const VehicleDescription& vehicle,
                           std::unique_ptr<ScanSource> sensor)
    : params_(params),
      vehicle_(vehicle),
      sensor_(std::move(sensor)),
      mapping_(params.mapping, sensor_->fan()),
      floor_(params.cell_m),
      clearance_(params.legs),
      cell_m_(params.cell_m) {
  log_.laser = sensor_->fan();
}

FloorLearner::News FloorLearner::take(const Observation& observation) {
  const Pose2 motion = odometry_step(vehicle_, observation.odometry);
  T_odom_vehicle_ = T_odom_vehicle_ * motion;
  T_scan_vehicle_ = T_scan_vehicle_ * motion;
  travelled_m_ += motion.position().norm();
  is_standing_ = motion.position().norm() < kStanding_m;
  ++cycles_since_look_;
  log_.odometry.push_back({observation.stamp_s, T_odom_vehicle_});
  const bool sees = sensor_->look(observation, view_);
  bool recognised = false;
  if (sees) {
    recognised = mapping_.take_scan(view_.ranges_m, T_scan_vehicle_);
    T_scan_vehicle_ = {};
    keep_scan(observation.stamp_s);
    if (log_.scans.size() == 1) T_map_home_ = mapping_.T_map_vehicle();
  }
  T_map_vehicle_ = mapping_.T_map_vehicle() * T_scan_vehicle_;
  if (recognised && places_moved()) begin_again();
  if (again_) return lay_on() ? News::kLoop : News::kNothing;
  if (!sees || !(is_time_to_look() || strikes_something_new())) return News::kNothing;
  looks_.push_back({log_.scans.size() - 1, view_.near_m, T_map_vehicle_});
  T_map_looked_ = T_map_vehicle_;
  cycles_since_look_ = 0;
  FloorBox changed = put(looks_.back(), T_map_vehicle_, floor_);
  for (const Touch& touch : contacts_) changed.include_box(put(touch, touch.T_map_put, floor_));
  clearance_.update(floor_, changed);
  return changed.empty() ? News::kNothing : News::kFloor;
}

void FloorLearner::touch(int direction) {
  contacts_.push_back({log_.scans.size() - 1, T_scan_vehicle_, direction, T_map_vehicle_});
  clearance_.update(floor_, put(contacts_.back(), T_map_vehicle_, floor_));
}

void FloorLearner::settle_home() {
  T_map_home_ = mapping_.lay_again(0, T_map_home_).value_or(T_map_home_);
}

bool FloorLearner::halve_cells() {
  if (cell_m_ / 2 < params_.cell_least_m) return false;
  cell_m_ /= 2;
  T_map_of_all_ = mapping_.T_map_vehicle_of_all();
  begin_again();
  return true;
}

void FloorLearner::keep_scan(double stamp_s) {
  LaserScan scan;
  scan.stamp_s = scan.time_s = stamp_s;
  scan.ranges_m = view_.ranges_m;
  scan.odometry_known = log_.odometry.size();
  log_.scans.push_back(std::move(scan));
}

bool FloorLearner::is_time_to_look() const {
  const Pose2 since = between(T_map_looked_, T_map_vehicle_);
  return looks_.empty() || since.position().norm() >= params_.look_every_m ||
         std::abs(since.theta) >= params_.look_every_rad || cycles_since_look_ >= params_.look_every_cycles;
}

/// What is thin is not hit by every scan: one that does must not be passed over.
bool FloorLearner::strikes_something_new() const {
  const LaserScanner& fan = sensor_->fan();
  const Pose2 T_map_laser = T_map_vehicle_ * fan.T_vehicle_laser;
  for (std::size_t beam = 0; beam < view_.ranges_m.size(); ++beam) {
    const double range_m = view_.ranges_m[beam];
    if (!(range_m > 0 && range_m < kNearBy_m)) continue;
    const FloorCell cell = floor_.cell_at(Vec2(T_map_laser * Vec2(range_m * unit(fan.beam_angle(beam)))));
    if (floor_.at(cell) == Floor::kFree && clearance_.to_occupied_m(cell) > kApart_m) return true;
  }
  return false;
}

FloorBox FloorLearner::put(const Look& look, const Pose2& T_map_vehicle, FloorGrid& floor) const {
  FloorBox changed = see_floor(floor, sensor_->fan(), log_.scans[look.scan_index].ranges_m, look.near_m,
                               T_map_vehicle, params_.view);
  const FloorBox stood =
      stand_on_floor(floor, look.scan_index == 0 ? set_down_room() : vehicle_.footprint, T_map_vehicle);
  changed.include_box(stood);
  return changed;
}

/// What no scan shows.
FloorBox FloorLearner::put(const Touch& touch, const Pose2& T_map_vehicle, FloorGrid& floor) const {
  return strike_floor(floor, vehicle_.footprint, T_map_vehicle, touch.direction);
}

/// Who sets a vehicle down leaves it a little room on all sides, ahead beyond the strip that it cannot see:
/// it does not stand before a table, and the jambs of a door in which it stands are no legs.
Footprint FloorLearner::set_down_room() const {
  Footprint room = vehicle_.footprint;
  room.rear_m += kSetDownBeside_m;
  room.width_m += 2 * kSetDownBeside_m;
  const std::vector<float>& near_m = looks_.front().near_m;
  if (!near_m.empty()) room.front_m = sensor_->fan().T_vehicle_laser.x + near_m[near_m.size() / 2];
  room.front_m += kSetDownAhead_m;
  return room;
}

FloorGrid FloorLearner::floor_from(std::span<const Pose2> T_map_vehicle) const {
  FloorGrid floor(cell_m_);
  for (const Look& look : looks_) put(look, T_map_vehicle[look.scan_index], floor);
  for (const Touch& touch : contacts_)
    put(touch, T_map_vehicle[touch.scan_index] * touch.T_scan_vehicle, floor);
  return floor;
}

/// A place was recognised: whether any scan lies elsewhere now, by more than the floor is accurate.
bool FloorLearner::places_moved() {
  T_map_of_all_ = mapping_.T_map_vehicle_of_all();
  T_map_home_ = T_map_of_all_.front();
  return std::any_of(looks_.begin(), looks_.end(), [&](const Look& look) {
    const Pose2 off = between(look.T_map_put, T_map_of_all_[look.scan_index]);
    return off.position().norm() + kLever_m * std::abs(off.theta) > kOutOfPlace_m;
  });
}

void FloorLearner::begin_again() {
  again_.emplace(cell_m_, clearance_.far_m(), params_.legs);
}

/// Lays a few scans more onto the floor as they lie now; true when all are laid.
bool FloorLearner::lay_on() {
  const auto portion = static_cast<std::size_t>(std::max(1.0, kLaidACycle * cell_m_ / kLaidCell_m));
  const std::size_t end = std::min(again_->next + portion, looks_.size());
  FloorBox changed;
  for (; again_->next < end; ++again_->next) {
    Look& look = looks_[again_->next];
    look.T_map_put = T_map_of_all_[look.scan_index];
    changed.include_box(put(look, look.T_map_put, again_->floor));
  }
  if (again_->next == looks_.size()) {
    for (Touch& touch : contacts_) {
      if (touch.scan_index < T_map_of_all_.size())  // else it was put down where places lie since
        touch.T_map_put = T_map_of_all_[touch.scan_index] * touch.T_scan_vehicle;
      changed.include_box(put(touch, touch.T_map_put, again_->floor));
    }
  }
  again_->clearance.update(again_->floor, changed);
  if (again_->next < looks_.size()) return false;
  floor_ = std::move(again_->floor);
  clearance_ = std::move(again_->clearance);
  again_.reset();
  return true;
}

}  // namespace aisle
