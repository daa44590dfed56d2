#include "aisle/missions/exploration/fleet_driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kMoves_mps = 0.01;
constexpr double kTurns_rad_s = 0.01;
constexpr double kPathEvery_m = 0.2;

bool is_stop(const Command& command) {
  return command.speed_mps == 0 && command.turn_rate_rad_s == 0;
}

}  // namespace

void FleetDriverParams::describe(FieldList& fields) {
  fields.group("guide", guide);
  fields.real("node_spacing_m", node_spacing_m, {1, 1000}, "nodes along a corridor are at most so far apart");
  fields.real("off_edge_m", off_edge_m, {0.2, 20}, "a path may lead so far off the edge that is driven");
  fields.real("retry_s", retry_s, {0.5, 3600}, "time until a blocked edge is tried again");
}

Result<std::unique_ptr<FleetDriver>> FleetDriver::make(const FleetDriverParams& params,
                                                       const std::string& building,
                                                       const VehicleDescription& vehicle,
                                                       const MissionStart& start,
                                                       const FleetIdentity& identity, FleetLink& link,
                                                       std::function<std::string()> timestamp) {
  if (Problems problems = identity.problems(); !problems.empty()) return problems;
  auto parsed = parse_building(building, "building");
  if (!parsed) return parsed.problems();
  if (Problems problems = check_guidable(*parsed, vehicle); !problems.empty()) return problems;
  return std::make_unique<FleetDriver>(params, vehicle, std::move(*parsed), start, identity, link,
                                       std::move(timestamp));
}

FleetDriver::FleetDriver(const FleetDriverParams& params, const VehicleDescription& vehicle,
                         Building building, const MissionStart& start, const FleetIdentity& identity,
                         FleetLink& link, std::function<std::string()> timestamp)
    : params_(params),
      vehicle_(vehicle),
      building_(std::move(building)),
      graph_(fleet_graph(building_, params.node_spacing_m)),
      navigator_(params.guide, vehicle, building_, home_of(building_), {}, scanner_scans(vehicle)),
      client_(identity,
              OrderTracker({building_.name, [this](const std::string& id) { return graph_.find(id); },
                            [this](const Vec2& p_map) { return why_not(p_map); }},
                           vehicle.footprint.front_m + params.guide.arrive_m),
              vehicle, link, std::move(timestamp)) {
  if (!start.is_home()) begin_finding(start.T_map_hint);
}

std::string FleetDriver::why_not(const Vec2& p_map) const {
  if (const Zone* zone = keep_out_around(building_.zones, p_map))
    return fmt::format("{:.2f}, {:.2f} lies in the {}", p_map.x(), p_map.y(), words_for(*zone));
  if (building_.floor->at(p_map) == Floor::kFree) return {};
  return fmt::format("no free floor is known at {:.2f}, {:.2f}", p_map.x(), p_map.y());
}

Decision FleetDriver::step(const Observation& observation) {
  Decision decision = finder_ ? find(observation) : drive(observation);
  client_.exchange(observation.stamp_s, vehicle_state(observation));
  take_initial_pose();
  follow_target(observation.stamp_s);
  if (!sent_ || retry_at_s_) decision.command = {};
  decision.command = slowed(decision.command);
  command_ = decision.command;
  stamp_s_ = observation.stamp_s;
  return decision;
}

/// The navigator goes to its target, or stands and keeps knowing where it is.
Decision FleetDriver::drive(const Observation& observation) {
  const double stamp_s = observation.stamp_s;
  Decision decision = navigator_.step(observation);
  if (needs_help_) return {.state = "lost"};
  if (navigator_.is_lost(stamp_s) && !observation.bumper_pressed) {
    ++times_lost_;
    begin_finding(navigator_.T_map_vehicle());
    return {.state = "lost"};
  }
  if (!sent_ || retry_at_s_) {
    const bool is_blocked = sent_.has_value();
    if (is_blocked && stamp_s >= *retry_at_s_) retry_at_s_.reset(), sent_.reset();
    return {.state = is_blocked ? "blocked" : "waiting"};
  }
  if (decision.status == NavigatorStatus::kFailed) return blocked(decision.why, stamp_s);
  if (decision.status == NavigatorStatus::kDone) {
    client_.tracker().arrive();
    sent_.reset();
    return {.state = "at node"};
  }
  if (const double off_m = path_off_edge_m(); off_m > params_.off_edge_m)
    return blocked(fmt::format("what is free leads {:.1f} m off the edge; {:.1f} m are allowed", off_m,
                               params_.off_edge_m),
                   stamp_s);
  return decision;
}

Decision FleetDriver::blocked(const std::string& why, double stamp_s) {
  client_.tracker().block(why);
  retry_at_s_ = stamp_s + params_.retry_s;
  navigator_.send_to({}, stamp_s);
  return {.state = "blocked", .why = why};
}

/// How far the path that is being followed leads off the straight edge to the target.
double FleetDriver::path_off_edge_m() const {
  const Segment2 edge{sent_->p_map_from, sent_->p_map};
  double off_m = 0;
  for (const PathPiece& piece : navigator_.path().pieces()) {
    const int steps = std::max(1, static_cast<int>(std::ceil(piece.path_m() / kPathEvery_m)));
    for (int k = 0; k <= steps; ++k)
      off_m = std::max(off_m, edge.distance(piece.at(piece.path_m() * k / steps).position()));
  }
  return off_m;
}

/// Sends the navigator where the order leads now.
void FleetDriver::follow_target(double stamp_s) {
  const auto target = finder_ || needs_help_ ? std::nullopt : client_.tracker().target();
  if (!target) return stand(stamp_s);
  if (sent_ && sent_->is_same(*target)) return;
  // The vehicle may stand off the node where the edge begins, as it may have been near enough to it.
  sent_ = *target;
  retry_at_s_.reset();
  navigator_.send_to({GoalPlace{target->p_map}}, stamp_s);
}

void FleetDriver::stand(double stamp_s) {
  retry_at_s_.reset();
  if (!sent_) return;
  sent_.reset();
  navigator_.send_to({}, stamp_s);
}

Command FleetDriver::slowed(Command command) const {
  if (!sent_ || !sent_->speed_max_mps) return command;
  const double speed_mps = std::abs(command.speed_mps);
  if (speed_mps <= *sent_->speed_max_mps) return command;
  const double share = *sent_->speed_max_mps / speed_mps;
  command.speed_mps *= share;
  command.turn_rate_rad_s *= share;  // the same curve, more slowly
  return command;
}

VehicleState FleetDriver::vehicle_state(const Observation& observation) {
  VehicleState state;
  const double seen_m = navigator_.localiser().seen_m();
  if (!finder_ && !needs_help_) state.T_map_vehicle = navigator_.T_map_vehicle();
  state.localisation_score = !finder_ && seen_m > 0 ? navigator_.localiser().fitting_m() / seen_m : 0;
  const Pose2 moved = odometry_step(vehicle_, observation.odometry);
  const double elapsed_s = stamp_s_ ? observation.stamp_s - *stamp_s_ : vehicle_.cycle_s;
  if (elapsed_s > 0) {
    state.speed_mps = std::copysign(moved.position().norm(), moved.x) / elapsed_s;
    state.turn_rate_rad_s = moved.theta / elapsed_s;
  }
  state.is_driving = !is_stop(command_) || std::abs(state.speed_mps) > kMoves_mps ||
                     std::abs(state.turn_rate_rad_s) > kTurns_rad_s;
  state.is_touching = observation.bumper_pressed;
  state.map_id = building_.name;
  return state;
}

void FleetDriver::begin_finding(const std::optional<Pose2>& T_map_hint) {
  finder_ = std::make_unique<PlaceFinder>(PlaceFinderParams{}, vehicle_, building_, T_map_hint);
}

void FleetDriver::take_initial_pose() {
  const auto pose = client_.tracker().take_initial_pose();
  if (!pose) return;
  if (const std::string why = why_not(pose->T_map_vehicle.position()); !why.empty())
    return client_.tracker().settle_initial_pose(why);
  begin_finding(pose->T_map_vehicle);
}

/// A vehicle that does not know where it is stands still: others drive beside it.
Decision FleetDriver::find(const Observation& observation) {
  const Decision found = finder_->step(observation);
  if (found.status == NavigatorStatus::kGoing) return {.state = "finding itself"};
  if (found.status == NavigatorStatus::kDone) {
    navigator_.begin_at(finder_->localiser().T_map_vehicle(), observation.stamp_s);
    client_.tracker().settle_initial_pose({});
    client_.tracker().fail({});
    needs_help_ = false;
    finder_.reset();
    return {.state = "found"};
  }
  client_.tracker().settle_initial_pose(found.why);
  client_.tracker().fail(found.why + "; initPosition says where it is");
  needs_help_ = true;
  finder_.reset();
  return {.state = "lost", .why = found.why};
}

}  // namespace aisle
