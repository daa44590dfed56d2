#include "aisle/guidance/landmarks/landmark_navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/learning/landmarks/landmark_expectation.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kFoundSigma_m = 0.1;  // of a relocalised pose, before the next image corrects it
constexpr double kFoundSigma_rad = 2 * kDegree;
constexpr double kWallsReach_m = 2;       // walls farther away may be others
constexpr std::size_t kKnownPairs = 4;    // this many known sightings, if they are ...
constexpr double kKnownShare = 0.7;       // ... this share of an image, confirm the vehicle's place
constexpr std::size_t kInImageLeast = 3;  // landmarks; with fewer, seeing none agrees with the map
constexpr double kUnmatchedBlocked_m =
    1;  // of unmatched path; then an obstacle on the taught path means that it is lost

const CameraDescription& camera_of(const VehicleDescription& vehicle, const Building& building) {
  if (building.camera) {
    if (const CameraDescription* camera = vehicle.camera(building.camera->name)) return *camera;
  }
  throw std::invalid_argument("the vehicle lacks the camera that the landmarks were seen with");
}

/// Poses along all routes of a building, there and back.
std::vector<Pose2> places_to_try(const Building& building, const Path& path, double apart_m) {
  std::vector<Pose2> places;
  const auto add = [&](const Path& ahead) {
    const auto steps = static_cast<int>(std::ceil(ahead.length_m() / apart_m));
    for (int i = 0; i <= steps; ++i) {
      const Pose2 there = ahead.at(ahead.length_m() * i / std::max(steps, 1)).T_map_path;
      places.push_back(there);
      places.push_back(there * Pose2{0, 0, kPi});
    }
  };
  for (const Route& route : building.routes) add(route.path);
  if (building.routes.empty()) add(path);
  return places;
}

/// The floor in view while the building was taught. A building without routes was taught along `path`.
TaughtView view_of(const Building& building, const FloorInImage& floor, const Path& path) {
  TaughtView view(floor);
  for (const Route& route : building.routes) view.add(route.path);
  if (building.routes.empty()) view.add(path);
  return view;
}

/// The vehicle with its reverse speed limited to the guard's.
VehicleDescription as_guarded(VehicleDescription vehicle, const LandmarkNavigatorParams& params) {
  double& max_mps = vehicle.limits.reverse_speed_max_mps;
  if (params.guarded) max_mps = std::min(max_mps, params.guard.reverse_speed_mps);
  return vehicle;
}

/// Known lines are enough of the last image to confirm the vehicle's place.
bool knows_what_it_sees(const LandmarkLocaliser& localiser) {
  return localiser.pairs().size() >= kKnownPairs && localiser.matched_share() >= kKnownShare;
}

std::unique_ptr<ExplorerNavigator> explorer_of_floor(double speed_mps, const VehicleDescription& vehicle,
                                                     const std::string& camera) {
  ExplorerNavigatorParams params;
  params.speed.speed_mps = speed_mps;
  return std::make_unique<ExplorerNavigator>(
      params, vehicle, ExploringOrder::kRecommended,
      vehicle.scanner ? scanner_scans(vehicle) : marker_scans(vehicle, camera));
}

double position_sigma_m(const Mat3& covariance) {
  return std::sqrt(covariance.topLeftCorner<2, 2>().trace());
}

}  // namespace

void LandmarkNavigatorParams::describe(FieldList& fields) {
  fields.group("sightings", sightings);
  fields.group("localiser", localiser);
  fields.group("relocation", relocation);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.group("guard", guard);
  fields.flag("guarded", guarded, "stop for obstacles in the path, and while the camera fails");
  fields.real("start_sigma_m", start_sigma_m, {0.001, 2}, "uncertainty of the start position");
  fields.angle("start_sigma_deg", start_sigma_rad, {0.1, 45}, "uncertainty of the start heading");
  fields.real("look_s", look_s, {0, 60}, "time to look where it stands before it starts");
  fields.real("unsure_m", unsure_m, {0.001, 5}, "position uncertainty above which it slows down");
  fields.real("lost_m", lost_m, {0.01, 10}, "position uncertainty above which it is lost");
  fields.angle("lost_deg", lost_rad, {0.1, 90}, "heading uncertainty above which it is lost");
  fields.real("unmatched_max_s", unmatched_max_s, {0.1, 60},
              "after this time with images that do not fit the map it is lost");
  fields.count("unmatched_sightings_min", unmatched_sightings_min, {1, 100},
               "an image that does not fit is unmatched if it has this many sightings in the taught view");
  fields.real("unmatched_max_m", unmatched_max_m, {0.1, 1000},
              "after this path with unmatched images it is lost; an image that fits halves the path");
  fields.real("search_speed_mps", search_speed_mps, {0, 1},
              "when lost, it drives at this speed to see more; 0: it stands");
  fields.real("search_max_m", search_max_m, {0, 50}, "when lost, it drives at most this far");
  fields.real("give_up_s", give_up_s, {1, 600}, "after standing lost for this long it gives up");
  fields.real("off_route_max_m", off_route_max_m, {0.1, 10},
              "relocalised farther from its route than this, it returns to it first");
}

LandmarkNavigator::LandmarkNavigator(const LandmarkNavigatorParams& params, const VehicleDescription& vehicle,
                                     const Building& building, const Path& route)
    : params_(params),
      vehicle_(as_guarded(vehicle, params)),
      building_(&building),
      path_(route),
      camera_(camera_of(vehicle, building).name),
      floor_in_image_(camera_of(vehicle, building)),
      detector_(params.sightings, camera_of(vehicle, building).intrinsics,
                camera_of(vehicle, building).mount),
      localiser_(params.localiser, vehicle, {}),
      consistency_(params.localiser, vehicle),
      relocator_(params.relocation, params.localiser, vehicle,
                 places_to_try(building, path_, params.relocation.apart_m)),
      follower_(vehicle, params.steering),
      progress_(path_),
      guard_(vehicle, params.guard, &camera_of(vehicle, building)),
      rules_(building, vehicle_),
      unmatched_(view_of(building, floor_in_image_, path_), params.unmatched_sightings_min),
      continuity_(floor_in_image_.nearest_m()) {
  place(about(path_.at(0).T_map_path, params.start_sigma_m, params.start_sigma_rad));
}

Decision LandmarkNavigator::step(const Observation& observation) {
  locate(observation);
  if (!state_since_s_) {
    state_since_s_ = observation.stamp_s;
    matched_stamp_s_ = observation.stamp_s;
  }
  if (observation.bumper_pressed)
    return {.status = NavigatorStatus::kFailed, .state = "bumped", .why = "the bumper is pressed"};
  if (const auto off_by = odometry_.off_by())
    return {.status = NavigatorStatus::kFailed,
            .state = "slipping",
            .why = fmt::format("the wheels count {:.1f} times the path that the camera sees", *off_by)};
  if (state_ == State::kLooking) return look_around(observation.stamp_s);
  if (was_kidnapped_ && (state_ == State::kFollowing || state_ == State::kReturning)) {
    interrupted_ = state_;
    begin(State::kCheckingConsistency);
  }
  if (state_ == State::kCheckingConsistency) return check_consistency();
  if (state_ == State::kFollowing) {
    why_lost_ = why_lost();
    if (!why_lost_.empty()) begin(State::kLost);
  }
  if (state_ == State::kLost) return relocalise(observation);
  if (state_ == State::kReturning) return return_to_route(observation);
  return guarded(follow(observation));
}

void LandmarkNavigator::begin(State state) {
  state_ = state;
  state_since_s_ = stamp_s_;
  if (state != State::kLost) return;
  was_kidnapped_ = false;
  searched_m_ = 0;
  searched_s_ = stamp_s_;
  explorer_.reset();
  relocator_.start();
}

void LandmarkNavigator::place(const UncertainPose2& T_map_vehicle) {
  localiser_.place(T_map_vehicle,
                   walls_around(building_->wall_directions, T_map_vehicle.mean.position(), kWallsReach_m));
  T_map_looked_ = localiser_.pose();
}

LandmarkFix LandmarkNavigator::fix() const {
  return {{localiser_.pose(), localiser_.covariance()},
          state_ == State::kFollowing,
          state_ == State::kLost || state_ == State::kReturning};
}

/// Updates pose and sightings by odometry, then by the image, which was seen from where the vehicle was when
/// it was taken.
void LandmarkNavigator::locate(const Observation& observation) {
  localiser_.predict(observation.odometry);
  sightings_.clear();
  match_ = LandmarkMatch::kNothing;
  const CameraImage* image = guard_.look(observation);
  has_looked_ = image != nullptr && localiser_.go_back(guard_.odometry().cycles_since(image->stamp_s));
  if (has_looked_) {
    look_at(*image->pixels);
    T_map_looked_ = localiser_.pose();
    if (match_ == LandmarkMatch::kMatched)
      odometry_.look(guard_.odometry().T_odom_at(image->stamp_s), T_map_looked_);
    localiser_.catch_up();
  }
  if (match_ == LandmarkMatch::kMatched || match_ == LandmarkMatch::kNothing)
    matched_stamp_s_ = observation.stamp_s;
  stamp_s_ = observation.stamp_s;
}

void LandmarkNavigator::look_at(const Image& image) {
  const Pose2 T_looked_now = between(T_map_looked_, localiser_.pose());
  scenes_.move(T_looked_now);
  stripes_.move(T_looked_now);
  continuity_.move(T_looked_now);
  recognition_.move(T_looked_now);
  sightings_ = detector_.detect(image);
  edges_on_floor_.clear();
  for (const FloorEdge& edge : detector_.floor_edges()) edges_on_floor_.push_back(edge.on_floor);
  if (state_ == State::kLooking || state_ == State::kFollowing)
    match_ = localiser_.correct(building_->landmarks, sightings_, edges_on_floor_);
  unmatched_.look(sightings_, match_ == LandmarkMatch::kMatched, localiser_.pose(),
                  (localiser_.pose().position() - T_map_looked_.position()).norm());
  check_for_kidnapping();
}

/// Lines come and go, so an image that fits only a little neither raises nor dispels the suspicion.
void LandmarkNavigator::check_for_kidnapping() {
  const bool fits = match_ == LandmarkMatch::kMatched;
  const bool is_known_here = fits && knows_what_it_sees(localiser_);
  if (stripes_.look(guard_.p_vehicle_returns(), is_known_here)) was_kidnapped_ = has_jumped_ = true;
  if (scenes_.look(sightings_, is_known_here)) was_kidnapped_ = true;
  if (state_ == State::kFollowing &&
      expectations_.look(expected_landmarks(building_->landmarks, fix().T_map_vehicle, sightings_,
                                            params_.localiser.landmark_sigma_m)))
    was_kidnapped_ = true;
  if (state_ == State::kFollowing && match_ != LandmarkMatch::kAmbiguous &&
      recognition_.look(sightings_.size(), localiser_.pairs().size(), is_known_here))
    was_kidnapped_ = has_jumped_ = true;
  if (fits && !is_known_here) return;
  const bool is_bare_here = sightings_.empty() && landmarks_in_image(building_->landmarks, localiser_.pose(),
                                                                     floor_in_image_) < kInImageLeast;
  if (continuity_.look(sightings_, is_known_here || is_bare_here) && state_ == State::kFollowing)
    was_kidnapped_ = has_jumped_ = true;
}

/// Why the vehicle is lost; empty if it is not.
std::string LandmarkNavigator::why_lost() const {
  const double sigma_m = position_sigma_m(localiser_.covariance());
  if (sigma_m > params_.lost_m)
    return fmt::format("saw no known landmark until its position was uncertain by {:.2f} m", sigma_m);
  if (std::sqrt(localiser_.covariance()(2, 2)) > params_.lost_rad) return "its heading is too uncertain";
  if (stamp_s_ - matched_stamp_s_ > params_.unmatched_max_s || unmatched_.path_m() > params_.unmatched_max_m)
    return "sees what the map does not contain";
  return "";
}

Decision LandmarkNavigator::look_around(double stamp_s) {
  if (stamp_s - *state_since_s_ >= params_.look_s) state_ = State::kFollowing;
  return {.state = "looking"};
}

/// A sudden change of view may have other causes: lines that come and go, wrong floor points. So the vehicle
/// stops and checks whether the map's landmarks are seen from where it believes to be.
Decision LandmarkNavigator::check_consistency() {
  const bool is_suspicion_new = std::exchange(was_kidnapped_, false);
  if (is_suspicion_new) consistency_.start(has_jumped_);
  const Suspicion suspicion = is_suspicion_new || !has_looked_
                                  ? Suspicion::kOpen
                                  : consistency_.look(building_->landmarks, fix().T_map_vehicle, sightings_);
  if (suspicion == Suspicion::kDispelled) {
    go_on(interrupted_);
    return {.state = interrupted_ == State::kFollowing ? "following" : "returning"};
  }
  why_lost_ = "the view has changed suddenly";
  if (suspicion == Suspicion::kConfirmed || stamp_s_ - *state_since_s_ > params_.give_up_s)
    begin(State::kLost);
  return {.state = state_ == State::kLost ? "lost" : "doubting", .why = why_lost_};
}

/// Goes on once its place is confirmed.
void LandmarkNavigator::go_on(State state) {
  begin(state);
  has_jumped_ = false;
  expectations_.start();
  recognition_.start();
  matched_stamp_s_ = stamp_s_;
  unmatched_.start();
}

/// Compares what it has seen since it was lost with all known places.
Decision LandmarkNavigator::relocalise(const Observation& observation) {
  if (std::exchange(was_kidnapped_, false)) {
    relocator_.start();
    explorer_.reset();
  }
  relocator_.predict(observation.odometry);
  if (observation.stamp_s - searched_s_ > params_.give_up_s)
    return {.status = NavigatorStatus::kFailed, .state = "lost", .why = why_lost_};
  const auto T_map_found = has_looked_ ? relocator_.look(building_->landmarks, sightings_) : std::nullopt;
  return T_map_found ? found(*T_map_found, observation) : search(observation);
}

/// Drives on if the route leads on from there in the direction of its heading; else returns to its route.
Decision LandmarkNavigator::found(const Pose2& T_map_vehicle, const Observation& observation) {
  place(about(T_map_vehicle, kFoundSigma_m, kFoundSigma_rad));
  odometry_.relocalise(guard_.odometry().T_odom_vehicle(), T_map_vehicle);
  if (progress_.find(T_map_vehicle, params_.off_route_max_m)) {
    go_on(State::kFollowing);
    return {.state = "found", .why = fmt::format("{:.1f} m along the route", progress_.point().along_m)};
  }
  why_lost_ = fmt::format("relocalised more than {:.1f} m off its route, or facing another way",
                          params_.off_route_max_m);
  if (!explorer_) return {.status = NavigatorStatus::kFailed, .state = "lost", .why = why_lost_};
  const FloorLearner& learner = explorer_->learner();
  path_to_route_ = std::make_unique<PathToRoute>(
      vehicle_, params_.steering, SpeedParams{.speed_mps = params_.search_speed_mps}, learner.floor());
  path_to_route_->begin(path_, T_map_vehicle * learner.T_map_vehicle().inverse(), T_map_vehicle);
  begin(State::kReturning);
  return {.command = {.steering_rad = steering_rad_of(observation.odometry)},
          .state = "returning",
          .why = why_lost_};
}

/// Drives over the floor that it explored while lost, by odometry alone: correcting its pose on the map would
/// shift it relative to that floor.
Decision LandmarkNavigator::return_to_route(const Observation& observation) {
  Decision decision{.state = "returning", .why = why_lost_};
  const PathToRoute::State state =
      path_to_route_->step(localiser_.pose(), steering_rad_of(observation.odometry), decision.command);
  if (state == PathToRoute::State::kThere && progress_.find(localiser_.pose(), params_.off_route_max_m)) {
    go_on(State::kFollowing);
  } else if (state == PathToRoute::State::kThere || state == PathToRoute::State::kNoPath) {
    return {.status = NavigatorStatus::kFailed, .state = "lost", .why = why_lost_};
  }
  const PathAhead ahead = path_to_route_->ahead(localiser_.pose(), params_.guard.reach_m);
  const Guarded allowed = guard_.allow(decision.command, ahead);
  if (allowed.state == GuardState::kBlocked)
    return {.status = NavigatorStatus::kFailed, .state = "lost", .why = allowed.why};
  decision.command = allowed.command;
  return rules_.obey(std::move(decision), localiser_.pose());
}

/// It must be able to see the floor around, and nobody may have drawn anything on the building's floor: while
/// lost, it does not know where that is.
bool LandmarkNavigator::may_search() const {
  return params_.guarded && params_.search_speed_mps > 0 && guard_.sees_obstacles() && rules_.empty() &&
         searched_m_ < params_.search_max_m;
}

/// Stands until all places were compared without success, then explores the floor around as in an unknown
/// building.
Decision LandmarkNavigator::search(const Observation& observation) {
  Decision decision{.state = "lost", .why = why_lost_};
  const bool has_looked_around = stamp_s_ - *state_since_s_ > params_.look_s && relocator_.rounds() > 0;
  if (!has_looked_around || !may_search()) return decision;
  if (!explorer_) explorer_ = explorer_of_floor(params_.search_speed_mps, vehicle_, camera_);
  const Decision next = explorer_->step(observation);
  if (next.status != NavigatorStatus::kGoing) {
    searched_m_ = params_.search_max_m;
    return decision;
  }
  decision.command = guard_.allow(next.command, {}).command;
  const double path_m = std::abs(decision.command.speed_mps) * vehicle_.cycle_s;
  searched_m_ += path_m;
  if (path_m > 0) searched_s_ = stamp_s_;
  return decision;
}

Decision LandmarkNavigator::follow(const Observation& observation) {
  const PathPoint& point = progress_.advance(localiser_.pose());
  if (progress_.has_arrived()) return {.status = NavigatorStatus::kDone, .state = "arrived"};
  const double sigma_m = position_sigma_m(localiser_.covariance());
  const double certainty =
      std::clamp((params_.lost_m - sigma_m) / (params_.lost_m - params_.unsure_m), 0.0, 1.0);
  const double speed_mps = speed_along(path_, point.along_m, certainty, vehicle_, params_.speed);
  return {.command = follower_.follow(path_, point, localiser_.pose(), speed_mps,
                                      steering_rad_of(observation.odometry)),
          .state = match_ == LandmarkMatch::kMatched ? "following" : "bridging"};
}

/// The decision, limited by what is drawn on the floor and by obstacles.
Decision LandmarkNavigator::guarded(Decision decision) {
  decision = rules_.obey(std::move(decision), localiser_.pose());
  if (decision.status != NavigatorStatus::kGoing || !params_.guarded) return decision;
  const PathAhead ahead = path_ahead(path_, progress_.point(), localiser_.pose(), params_.guard.reach_m);
  Guarded allowed = guard_.allow(decision.command, ahead);
  if (allowed.state != GuardState::kFree && unmatched_.is_unmatched() &&
      unmatched_.path_m() > kUnmatchedBlocked_m) {
    why_lost_ = "sees what the map does not contain, and something is in the path";
    begin(State::kLost);
    return {.state = "lost", .why = why_lost_};
  }
  decision.command = allowed.command;
  if (allowed.state != GuardState::kFree) decision.state = "waiting";
  if (allowed.state == GuardState::kBlocked) {
    decision.status = NavigatorStatus::kFailed;
    decision.state = "blocked";
  }
  if (!allowed.why.empty()) decision.why = std::move(allowed.why);
  return decision;
}

}  // namespace aisle
