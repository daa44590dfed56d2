#include "aisle/guidance/exploration/place_finder.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/learning/walls/motion_noise.hpp"
#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {

void PlaceFinderParams::describe(FieldList& fields) {
  fields.group("localiser", localiser);
  fields.real("time_max_s", time_max_s, {1, 3600}, "it gives up finding itself after this time");
  fields.real("path_max_m", path_max_m, {0, 1000}, "it gives up finding itself after this path");
}

PlaceFinder::PlaceFinder(const PlaceFinderParams& params, const VehicleDescription& vehicle,
                         const Building& building, const std::optional<Pose2>& T_map_hint)
    : params_(params),
      vehicle_(vehicle),
      sensor_(scanner_scans(vehicle)),
      explorer_({}, vehicle, ExploringOrder::kRecommended, scanner_scans(vehicle)),
      localiser_(params.localiser, building) {
  if (T_map_hint) localiser_.take_hint(*T_map_hint);
}

void PlaceFinder::see(const Observation& observation) {
  const Pose2 step = odometry_step(vehicle_, observation.odometry);
  path_m_ += step.position().norm();
  T_scan_vehicle_ = T_scan_vehicle_ * step;
  if (!sensor_->look(observation, view_)) return;
  const LaserScanner& scanner = sensor_->scanner();
  points_of(scanner, view_.ranges_m, hits_);
  for (Vec2& hit : hits_) hit = scanner.T_vehicle_laser * hit;
  const Pose2 moved = std::exchange(T_scan_vehicle_, {});
  localiser_.take_scan({hits_, scanner.T_vehicle_laser.position(), observation.stamp_s},
                       {moved, kReadEveryCycle.covariance(moved)});
}

Decision PlaceFinder::step(const Observation& observation) {
  if (!begun_s_) begun_s_ = observation.stamp_s;
  see(observation);
  if (localiser_.is_found()) return {.status = NavigatorStatus::kDone, .state = "found"};
  Decision decision = explorer_.step(observation);
  const bool has_ended = decision.status != NavigatorStatus::kGoing;
  if (has_ended || observation.stamp_s - *begun_s_ > params_.time_max_s || path_m_ > params_.path_max_m)
    return {.status = NavigatorStatus::kFailed, .state = "not found", .why = why_not_found()};
  decision.state = "finding itself";
  return decision;
}

std::string PlaceFinder::why_not_found() const {
  const auto& places = localiser_.places();
  if (localiser_.state() == LocaliserState::kNotHere)
    return "not found: what it sees fits nowhere in this building";
  if (places.empty()) return "not found: it has seen too little that it could recognise";
  const Pose2& T = places.front().T_map_vehicle;
  if (places.size() == 1 && localiser_.knows_all_places())
    return fmt::format(
        "not found: one place fits, {:.1f}, {:.1f}, {:.0f} degrees, but not well enough to be sure: it "
        "explains "
        "{:.0f} % of what is seen; --at tells that it is there",
        T.x, T.y, to_degrees(T.theta), 100 * places.front().fit.explained_share());
  return fmt::format(
      "not found: {} places look alike{}, the likeliest at {:.1f}, {:.1f}, {:.0f} degrees; --at tells them "
      "apart",
      places.size(), localiser_.knows_all_places() ? "" : " at least", T.x, T.y, to_degrees(T.theta));
}

}  // namespace aisle
