#include "aisle/guidance/rooms/place_parking.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace aisle {
namespace {

/// The path from its end to its start, driven in reverse.
Path driven_backwards(const Path& path) {
  std::vector<PathPiece> pieces;
  for (auto piece = path.pieces().rbegin(); piece != path.pieces().rend(); ++piece)
    pieces.push_back({piece->end(), {-piece->arc.length_m, -piece->arc.turn_rad}});
  return Path(std::move(pieces));
}

}  // namespace

void PlaceParkingParams::describe(FieldList& fields) {
  fields.group("steering", steering);
  fields.real("lateral_m", lateral_m, {0.005, 1}, "lateral error above which it tries again");
  fields.angle("turned_deg", turned_rad, {0.1, 45}, "yaw error above which it tries again");
  fields.real("lateral_max_m", lateral_max_m, {0.005, 1},
              "lateral error after the last try above which it has not parked");
  fields.angle("turned_max_deg", turned_max_rad, {0.1, 90},
               "yaw error after the last try above which it has not parked");
  fields.real("taken_max_m", taken_max_m, {0, 1}, "lateral error allowed if an obstacle stands at its place");
  fields.real("back_off_m", back_off_m, {0.2, 5}, "path back before it tries again");
  fields.real("back_off_min_m", back_off_min_m, {0, 5}, "with less free path behind it goes no farther back");
  fields.real("reverse_speed_mps", reverse_speed_mps, {0.02, 1}, "while backing off");
  fields.count("tries_max", tries_max, {1, 100}, "attempts; after the last one it stays where it is");
}

PlaceParking::PlaceParking(const PlaceParkingParams& params, const VehicleDescription& vehicle, Path path)
    : params_(params),
      vehicle_(vehicle),
      path_(std::move(path)),
      path_back_(driven_backwards(path_)),
      follower_(vehicle, params.steering) {}

double PlaceParking::steering_rad(const PathPoint& point, const Pose2& T_map_vehicle, double speed_mps,
                                  double steering_now_rad) const {
  return follower_.follow(path_, point, T_map_vehicle, speed_mps, steering_now_rad).steering_rad;
}

Decision PlaceParking::settle(const Pose2& T_map_vehicle, bool is_taken) {
  const Pose2 off = between(path_.end(), T_map_vehicle);
  const auto is_within = [&](double lateral_m, double turned_rad) {
    return std::abs(off.y) <= lateral_m && std::abs(off.theta) <= turned_rad;
  };
  const std::string why = fmt::format("{:.2f} m to the side, {:.1f} degrees turned", std::abs(off.y),
                                      std::abs(to_degrees(off.theta)));
  if (is_within(params_.lateral_m, params_.turned_rad))
    return {.status = NavigatorStatus::kDone, .state = "parked", .why = why};
  if (tries_ < params_.tries_max) {
    ++tries_;
    back_from_ = T_map_vehicle;
    return {.state = "backing off", .why = why};
  }
  if (is_within(params_.lateral_max_m, params_.turned_max_rad))
    return {.status = NavigatorStatus::kDone, .state = "parked", .why = why};
  if (is_taken && is_within(params_.taken_max_m, params_.turned_max_rad))
    return {.status = NavigatorStatus::kDone,
            .state = "parked",
            .why = why + ", as near as the obstacle there allows"};
  return {.status = NavigatorStatus::kFailed, .state = "misaligned", .why = "not parked: it stands " + why};
}

Command PlaceParking::back_off(const Pose2& T_map_vehicle, double steering_now_rad) const {
  const PathPoint point = path_back_.nearest(T_map_vehicle.position(), 0, 2 * params_.back_off_m);
  return follower_.follow(path_back_, point, T_map_vehicle, params_.reverse_speed_mps, steering_now_rad);
}

void PlaceParking::judge_path_back(const Pose2& T_map_vehicle, double free_m) {
  const double backed_m = (T_map_vehicle.position() - back_from_->position()).norm();
  if (backed_m >= params_.back_off_m || free_m <= params_.back_off_min_m) back_from_.reset();
}

}  // namespace aisle
