#include "aisle/guidance/exploration/floor_learner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kInitialAhead_m = 0.15;
constexpr double kInitialBeside_m = 0.1;
constexpr double kOutOfPlace_m = 0.025;  // the floor is rebuilt when a scan lies this far from where it was
constexpr double kLever_m = 2;           // turns a heading error into a distance
constexpr double kRebuiltACycle = 8;     // scans added per cycle in a rebuild, with cells ...
constexpr double kRebuiltCell_m = 0.05;  // ... of this width
constexpr double kNearBy_m = 2.5;        // a laser return this near may be in the path soon ...
constexpr double kApart_m = 0.1;         // ... and is new if no obstacle is this near to it
constexpr double kStanding_m = 0.002;    // of path in a cycle

}  // namespace

void FloorLearnerParams::describe(FieldList& fields) {
  fields.group("mapping", mapping);
  fields.group("view", view);
  fields.group("legs", legs);
  fields.real("cell_m", cell_m, {0.02, 0.2}, "width of the floor's cells");
  fields.real("cell_least_m", cell_least_m, {0.02, 0.2},
              "cells are halved down to this while frontiers stay out of reach");
  fields.real("look_every_m", look_every_m, {0.02, 2}, "path after which the floor is updated");
  fields.angle("look_every_deg", look_every_rad, {0.5, 90}, "turn after which the floor is updated");
  fields.count("look_every_cycles", look_every_cycles, {1, 1000}, "cycles after which the floor is updated");
}

FloorLearner::FloorLearner(const FloorLearnerParams& params, const VehicleDescription& vehicle,
                           std::unique_ptr<ScanSource> sensor)
    : params_(params),
      vehicle_(vehicle),
      sensor_(std::move(sensor)),
      mapping_(params.mapping, sensor_->scanner()),
      floor_(FloorGrid(params.cell_m), FloorClearance(params.legs)),
      cell_m_(params.cell_m) {
  log_.laser() = sensor_->scanner();
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
  if (recognised && places_moved()) begin_rebuild();
  if (rebuild_) return continue_rebuild() ? News::kLoop : News::kNothing;
  if (!sees || !(is_time_to_look() || hits_something_new())) return News::kNothing;
  looks_.push_back({log_.scans.size() - 1, view_.near_m, viewpoint(), T_map_vehicle_});
  T_map_looked_ = T_map_vehicle_;
  cycles_since_look_ = 0;
  const FloorBox changed = floor_.change([this](FloorGrid& grid) {
    FloorBox put_here = put(looks_.back(), T_map_vehicle_, grid);
    for (const Contact& contact : contacts_) put_here.include_box(put(contact, contact.T_map_put, grid));
    return put_here;
  });
  return changed.empty() ? News::kNothing : News::kFloor;
}

void FloorLearner::add_contact(Gear gear) {
  contacts_.push_back({log_.scans.size() - 1, T_scan_vehicle_, gear, T_map_vehicle_});
  floor_.change([this](FloorGrid& grid) { return put(contacts_.back(), T_map_vehicle_, grid); });
}

void FloorLearner::settle_home() {
  T_map_home_ = mapping_.lay_again(0, T_map_home_).value_or(T_map_home_);
}

bool FloorLearner::halve_cells() {
  if (cell_m_ / 2 < params_.cell_least_m) return false;
  cell_m_ /= 2;
  T_map_of_all_ = mapping_.T_map_vehicle_of_all();
  begin_rebuild();
  return true;
}

void FloorLearner::keep_scan(double stamp_s) {
  LaserScan scan;
  scan.stamp_s = scan.time_s = stamp_s;
  scan.ranges_m = view_.ranges_m;
  scan.odometry_known = log_.odometry.size();
  log_.scans.push_back(std::move(scan));
}

/// Whether the vehicle has moved since the last look.
Viewpoint FloorLearner::viewpoint() const {
  const Pose2 since = between(T_map_looked_, T_map_vehicle_);
  const bool has_moved = looks_.empty() || since.position().norm() >= params_.look_every_m ||
                         std::abs(since.theta) >= params_.look_every_rad;
  return has_moved ? Viewpoint::kMoved : Viewpoint::kSame;
}

bool FloorLearner::is_time_to_look() const {
  return viewpoint() == Viewpoint::kMoved || cycles_since_look_ >= params_.look_every_cycles;
}

/// Not every scan hits a thin obstacle, so one that does must not be skipped.
bool FloorLearner::hits_something_new() const {
  const LaserScanner& scanner = sensor_->scanner();
  const Pose2 T_map_laser = T_map_vehicle_ * scanner.T_vehicle_laser;
  for (std::size_t beam = 0; beam < view_.ranges_m.size(); ++beam) {
    const double range_m = view_.ranges_m[beam];
    if (!(range_m > 0 && range_m < kNearBy_m)) continue;
    const FloorCell cell =
        floor_.grid().cell_at(Vec2(T_map_laser * Vec2(range_m * unit(scanner.beam_angle(beam)))));
    if (floor_.grid().at(cell) == Floor::kFree && floor_.clearance().to_occupied_m(cell) > kApart_m)
      return true;
  }
  return false;
}

FloorBox FloorLearner::put(const Look& look, const Pose2& T_map_vehicle, FloorGrid& floor) const {
  const LaserScan& scan = log_.scans[look.scan_index];
  FloorBox changed = floor.pass_time(scan.stamp_s);
  changed.include_box(see_floor(floor, sensor_->scanner(), scan.ranges_m, look.near_m, T_map_vehicle,
                                params_.view, look.viewpoint));
  const FloorBox stood =
      stand_on_floor(floor, look.scan_index == 0 ? initial_free_area() : vehicle_.footprint, T_map_vehicle);
  changed.include_box(stood);
  return changed;
}

FloorBox FloorLearner::put(const Contact& contact, const Pose2& T_map_vehicle, FloorGrid& floor) const {
  return strike_floor(floor, vehicle_.footprint, T_map_vehicle, contact.gear);
}

/// The area taken as free at the start. Whoever places the vehicle leaves it some space on all sides, and
/// ahead of its blind zone: it does not stand right before a table, and if it stands in a door, the jambs are
/// not a table's legs.
Footprint FloorLearner::initial_free_area() const {
  Footprint area = vehicle_.footprint;
  area.rear_m += kInitialBeside_m;
  area.width_m += 2 * kInitialBeside_m;
  const std::vector<float>& near_m = looks_.front().near_m;
  if (!near_m.empty()) area.front_m = sensor_->scanner().T_vehicle_laser.x + near_m[near_m.size() / 2];
  area.front_m += kInitialAhead_m;
  return area;
}

FloorGrid FloorLearner::floor_from(std::span<const Pose2> T_map_vehicle) const {
  FloorGrid floor(cell_m_);
  for (const Look& look : looks_) put(look, T_map_vehicle[look.scan_index], floor);
  for (const Contact& contact : contacts_)
    put(contact, T_map_vehicle[contact.scan_index] * contact.T_scan_vehicle, floor);
  floor.forget_dynamic();
  return floor;
}

/// After a loop closure: whether any scan has moved by more than the floor's accuracy.
bool FloorLearner::places_moved() {
  T_map_of_all_ = mapping_.T_map_vehicle_of_all();
  T_map_home_ = T_map_of_all_.front();
  return std::any_of(looks_.begin(), looks_.end(), [&](const Look& look) {
    const Pose2 off = between(look.T_map_put, T_map_of_all_[look.scan_index]);
    return off.position().norm() + kLever_m * std::abs(off.theta) > kOutOfPlace_m;
  });
}

void FloorLearner::begin_rebuild() {
  rebuild_.emplace(
      Rebuild{KnownFloor(FloorGrid(cell_m_), FloorClearance(params_.legs, floor_.clearance().far_m()))});
}

/// Adds a few more scans to the new floor; true when all are added.
bool FloorLearner::continue_rebuild() {
  const auto portion = static_cast<std::size_t>(std::max(1.0, kRebuiltACycle * cell_m_ / kRebuiltCell_m));
  const std::size_t end = std::min(rebuild_->next + portion, looks_.size());
  rebuild_->floor.change([&](FloorGrid& grid) {
    FloorBox changed;
    for (; rebuild_->next < end; ++rebuild_->next) {
      Look& look = looks_[rebuild_->next];
      look.T_map_put = T_map_of_all_[look.scan_index];
      changed.include_box(put(look, look.T_map_put, grid));
    }
    if (end == looks_.size()) changed.include_box(put_contacts_again(grid));
    return changed;
  });
  if (end < looks_.size()) return false;
  floor_ = std::move(rebuild_->floor);
  rebuild_.reset();
  return true;
}

FloorBox FloorLearner::put_contacts_again(FloorGrid& grid) {
  FloorBox changed;
  for (Contact& contact : contacts_) {
    if (contact.scan_index < T_map_of_all_.size())  // later contacts have their new pose already
      contact.T_map_put = T_map_of_all_[contact.scan_index] * contact.T_scan_vehicle;
    changed.include_box(put(contact, contact.T_map_put, grid));
  }
  return changed;
}

}  // namespace aisle
