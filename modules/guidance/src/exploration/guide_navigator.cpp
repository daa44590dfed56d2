#include "aisle/guidance/exploration/guide_navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kWatchAhead_m = 1.5;
constexpr double kGetsOn_m = 0.3;                   // moving this far counts as progress
constexpr double kSearchAgain_s = 2;                // after no path was found
constexpr double kFacingPlanned_rad = 8 * kDegree;  // more than half of what a search turns at once
constexpr double kFacingExactly_rad = 2 * kDegree;
constexpr double kTurnWithin_m = 4;  // of the place, to turn there
constexpr int kTurnsMax = 3;

UncertainPose2 about_start(const Pose2& T_map_start, const GuideNavigatorParams& params) {
  const Vec3 sigma(params.start_sigma_m, params.start_sigma_m, params.start_sigma_rad);
  return {T_map_start, sigma.cwiseAbs2().asDiagonal()};
}

KnownFloor floor_of(const Building& building, const LegParams& legs) {
  if (!building.floor) throw std::invalid_argument("a building to be guided in needs its floor");
  FloorClearance clearance(legs);
  clearance.bar(lines_not_crossed(building), building.floor->cell_m());
  return KnownFloor(*building.floor, std::move(clearance), building.zones);
}

}  // namespace

void GuideNavigatorParams::describe(FieldList& fields) {
  fields.group("localiser", localiser);
  fields.group("view", view);
  fields.group("legs", legs);
  fields.group("search", search);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.real("start_sigma_m", start_sigma_m, {0.001, 2}, "uncertainty of the start position");
  fields.angle("start_sigma_deg", start_sigma_rad, {0.05, 30}, "uncertainty of the start heading");
  fields.real("look_s", look_s, {0, 60}, "time to look around before it starts");
  fields.real("look_every_m", look_every_m, {0.02, 2}, "path after which the floor is updated");
  fields.real("look_every_s", look_every_s, {0.05, 10}, "time after which the floor is updated");
  fields.real("arrive_m", arrive_m, {0.05, 3}, "distance at which a place counts as reached");
  fields.real("lost_s", lost_s, {0.5, 60}, "after seeing unknown walls for this long it is lost");
  fields.real("give_up_s", give_up_s, {1, 3600}, "without progress for this long it gives up");
  fields.count("expansions", expansions, {10, 100000}, "poses that the path search expands in a cycle");
}

GuideNavigator::GuideNavigator(const GuideNavigatorParams& params, const VehicleDescription& vehicle,
                               const Building& building, const Pose2& T_map_start,
                               std::vector<GoalPlace> places, std::unique_ptr<ScanSource> sensor)
    : params_(params),
      vehicle_(vehicle),
      sensor_(std::move(sensor)),
      building_(building),
      localiser_(params.localiser, sensor_->scanner(), building.walls, about_start(T_map_start, params)),
      floor_(floor_of(building, params.legs)),
      search_(params.search, vehicle),
      driver_(vehicle, params.steering, params.speed),
      rules_(building, vehicle),
      places_(std::move(places)),
      T_map_vehicle_(T_map_start) {}

Decision GuideNavigator::step(const Observation& observation) {
  Decision decision = decide(observation);
  decision.command = rules_.slowed(decision.command, T_map_vehicle_);
  return decision;
}

Decision GuideNavigator::decide(const Observation& observation) {
  const double stamp_s = observation.stamp_s;
  if (!begun_s_) begun_s_ = localised_s_ = progress_s_ = stamp_s;
  locate(observation);
  if (const std::string why = why_failed(observation); !why.empty())
    return {.status = NavigatorStatus::kFailed, .state = "given up", .why = why};
  if (stamp_s - *begun_s_ < params_.look_s) return {.state = "looking"};
  check_path();
  if (next_ < places_.size()) search_path(stamp_s);
  if (next_ == places_.size())
    return {.status = NavigatorStatus::kDone, .state = "arrived", .why = missed_headings()};
  return drive(observation);
}

void GuideNavigator::send_to(std::vector<GoalPlace> places, double stamp_s) {
  places_ = std::move(places);
  next_ = 0;
  headings_.clear();
  begin_place(stamp_s);
}

void GuideNavigator::remove_place(std::size_t place, double stamp_s) {
  places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(place));
  if (place == next_) begin_place(stamp_s);
}

/// It has driven no part of the path to the next place.
void GuideNavigator::begin_place(double stamp_s) {
  facing_ = {};
  progress_s_ = stamp_s;
  relaxes_clearance_ = false;
  drop_path();
}

void GuideNavigator::relocate(const Pose2& T_map_vehicle, double stamp_s) {
  begin_at(about_start(T_map_vehicle, params_), stamp_s);
}

void GuideNavigator::begin_at(const UncertainPose2& T_map_vehicle, double stamp_s) {
  localiser_.begin_at(T_map_vehicle);
  T_map_vehicle_ = T_map_vehicle.mean;
  T_scan_vehicle_ = {};
  localised_s_ = progress_s_ = stamp_s;
  floor_ = floor_of(building_, params_.legs);
  drop_path();
}

void GuideNavigator::locate(const Observation& observation) {
  T_scan_vehicle_ = T_scan_vehicle_ * odometry_step(vehicle_, observation.odometry);
  const bool sees = sensor_->look(observation, view_);
  if (sees) localiser_.take_scan(view_.ranges_m, std::exchange(T_scan_vehicle_, {}));
  T_map_vehicle_ = localiser_.T_map_vehicle().mean * T_scan_vehicle_;
  if (!localiser_.is_doubtful()) localised_s_ = observation.stamp_s;
  if (sees && !localiser_.is_doubtful()) look_at_floor(observation.stamp_s);
}

void GuideNavigator::look_at_floor(double stamp_s) {
  const bool moved = between(T_map_looked_, T_map_vehicle_).position().norm() >= params_.look_every_m;
  if (!moved && stamp_s - looked_s_ < params_.look_every_s) return;
  looked_s_ = stamp_s;
  T_map_looked_ = T_map_vehicle_;
  const Viewpoint viewpoint = moved ? Viewpoint::kMoved : Viewpoint::kSame;
  floor_.change([this, viewpoint, stamp_s](FloorGrid& grid) {
    FloorBox changed = grid.pass_time(stamp_s);
    changed.include_box(see_floor(grid, sensor_->scanner(), view_.ranges_m, view_.near_m, T_map_vehicle_,
                                  params_.view, viewpoint));
    changed.include_box(stand_on_floor(grid, vehicle_.footprint, T_map_vehicle_));
    return changed;
  });
}

std::string GuideNavigator::why_failed(const Observation& observation) {
  if (observation.bumper_pressed) return "the bumper is pressed";
  if (const Zone* zone = keep_out_around(building_.zones, T_map_vehicle_.position()))
    return fmt::format("is in the {}", words_for(*zone));
  if (is_lost(observation.stamp_s)) return "lost: what it sees fits no walls that it knows";
  if (next_ == places_.size() || observation.stamp_s - progress_s_ <= params_.give_up_s) return "";
  const Vec2& p = places_[next_].p_map;
  return fmt::format("there is no path to {:.1f}, {:.1f}{}", p.x(), p.y(),
                     rules_.empty() ? "" : " that obeys the building's keep-out lines, glass and zones");
}

/// Something may have come into the path.
void GuideNavigator::check_path() {
  const double watched_m = std::min(kWatchAhead_m, driver_.left_m());
  if (driver_.free_m(floor_, T_map_vehicle_) >= watched_m - 1e-6) return;
  ++ways_closed_;
  drop_path();
}

void GuideNavigator::drop_path() {
  driver_.drop();
  search_.stop();
}

bool GuideNavigator::is_at_place(const Pose2& T_map_vehicle) const {
  const Footprint& footprint = vehicle_.footprint;
  const Segment2 axis{T_map_vehicle * Vec2(-footprint.rear_m, 0), T_map_vehicle * Vec2(footprint.front_m, 0)};
  return axis.distance(places_[next_].p_map) <= params_.arrive_m;
}

double GuideNavigator::off_heading_rad(const Pose2& T_map_vehicle) const {
  return wrap_angle(T_map_vehicle.theta - *places_[next_].heading_rad);
}

/// At a place that has a heading: reaches it, or turns on the spot.
/// @return false: it is elsewhere, or a path that turns it must be searched
bool GuideNavigator::arrive_facing(double stamp_s) {
  if (!places_[next_].heading_rad || !is_at_place(T_map_vehicle_)) return false;
  const double off_rad = off_heading_rad(T_map_vehicle_);
  if (std::abs(off_rad) > kFacing_rad && facing_.turns_tried < kTurnsMax) {
    ++facing_.turns_tried;
    facing_.is_ignored = false;
    progress_s_ = stamp_s;
    return false;
  }
  const bool turns = vehicle_.is_differential && std::abs(off_rad) > kFacingExactly_rad &&
                     std::abs(off_rad) <= kFacing_rad && !std::exchange(facing_.has_turned_fully, true);
  if (turns) {
    driver_.take(Path({{T_map_vehicle_, {.length_m = 0, .turn_rad = -off_rad}}}));
  } else {
    reach_place(stamp_s);
  }
  return true;
}

/// No path leads to the place and its heading: it drives there all the same.
void GuideNavigator::give_up_heading(double stamp_s) {
  progress_s_ = stamp_s;
  relaxes_clearance_ = false;
  search_.stop();
  if (is_at_place(T_map_vehicle_)) return reach_place(stamp_s);
  facing_.is_ignored = true;
}

void GuideNavigator::reach_place(double stamp_s) {
  if (places_[next_].heading_rad) {
    const double off_rad = off_heading_rad(T_map_vehicle_);
    headings_.push_back({next_, off_rad, std::abs(off_rad) <= kFacing_rad});
  }
  ++next_;
  progress_s_ = stamp_s;
  facing_ = {};
}

std::string GuideNavigator::missed_headings() const {
  std::string words;
  for (const GoalHeading& heading : headings_) {
    if (heading.is_reached) continue;
    const GoalPlace& place = places_[heading.place];
    words +=
        fmt::format("{}at {:.1f}, {:.1f} it stands {:.0f} degrees off the heading {:.0f}: no path turns it",
                    words.empty() ? "" : "; ", place.p_map.x(), place.p_map.y(),
                    std::abs(to_degrees(heading.off_rad)), to_degrees(*place.heading_rad));
  }
  return words;
}

void GuideNavigator::begin_search() {
  const GoalPlace& place = places_[next_];
  const bool turns = seeks_heading();
  search_.look_for(
      floor_, T_map_vehicle_, place.p_map, vehicle_.footprint.front_m, [this, turns](const Pose2& T_map) {
        return is_at_place(T_map) && (!turns || std::abs(off_heading_rad(T_map)) <= kFacingPlanned_rad);
      });
  search_.forbid_first(std::exchange(blocked_direction_, std::nullopt));
  if (relaxes_clearance_) search_.relax_clearance();
  if (turns && is_at_place(T_map_vehicle_))
    search_.keep_to([p_map = place.p_map](const Pose2& T_map) {
      return (T_map.position() - p_map).norm() <= kTurnWithin_m;
    });
}

void GuideNavigator::search_path(double stamp_s) {
  if ((T_map_vehicle_.position() - p_map_progress_).norm() > kGetsOn_m) {
    progress_s_ = stamp_s;
    p_map_progress_ = T_map_vehicle_.position();
  }
  if (driver_.has_path()) return;
  if (search_.state() == CarSearch::State::kIdle) {
    if (arrive_facing(stamp_s)) return;
    begin_search();
  }
  if (search_.state() == CarSearch::State::kNone) {
    if (!relaxes_clearance_ && stamp_s - searched_s_ < kSearchAgain_s) return;
    begin_search();
  }
  const CarSearch::State state = search_.advance(floor_, params_.expansions);
  if (state == CarSearch::State::kNone) search_again(stamp_s);
  if (state != CarSearch::State::kFound) return;
  relaxes_clearance_ = false;
  const Path path = search_.path();
  search_.stop();
  if (path.empty()) {
    reach_place(stamp_s);
  } else {
    driver_.take(path);
  }
}

/// No path was found: with less clearance there may be one, or without the heading.
void GuideNavigator::search_again(double stamp_s) {
  searched_s_ = stamp_s;
  const bool turns = seeks_heading();
  if (turns && relaxes_clearance_) return give_up_heading(stamp_s);
  if (turns) progress_s_ = stamp_s;
  relaxes_clearance_ = !relaxes_clearance_;
}

Decision GuideNavigator::drive(const Observation& observation) {
  driver_.see(sensor_->scanner(), view_.ranges_m);
  const PathDriver::Step step = driver_.drive(floor_, search_.footprint_clearance(), T_map_vehicle_,
                                              steering_rad_of(observation.odometry));
  const bool drives =
      step.state == PathDriver::State::kDriving || step.state == PathDriver::State::kTurningWheels;
  if (step.state == PathDriver::State::kBlocked) blocked_direction_ = step.direction;
  if (!drives && driver_.has_path()) drop_path();
  return {.command = step.command, .state = drives ? "driving" : "searching"};
}

}  // namespace aisle
