#pragma once
/// Drives a taught route by its landmarks: C98 Algorithm 3.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/exploration/explorer_navigator.hpp"
#include "aisle/guidance/landmarks/continuity_monitor.hpp"
#include "aisle/guidance/landmarks/expectation_monitor.hpp"
#include "aisle/guidance/landmarks/odometry_monitor.hpp"
#include "aisle/guidance/landmarks/path_to_route.hpp"
#include "aisle/guidance/landmarks/place_consistency.hpp"
#include "aisle/guidance/landmarks/recognition_monitor.hpp"
#include "aisle/guidance/landmarks/scene_monitor.hpp"
#include "aisle/guidance/landmarks/stripe_monitor.hpp"
#include "aisle/guidance/landmarks/unmatched_monitor.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/guidance/obstacles/floor_rules.hpp"
#include "aisle/guidance/obstacles/obstacle_guard.hpp"
#include "aisle/learning/landmarks/landmark_localiser.hpp"
#include "aisle/learning/landmarks/landmark_relocation.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct LandmarkNavigatorParams {
  LandmarkSightingParams sightings;
  LandmarkLocaliserParams localiser;
  LandmarkRelocationParams relocation;
  SteeringParams steering;
  SpeedParams speed;
  ObstacleGuardParams guard;
  bool guarded = true;
  double start_sigma_m = 0.15;
  double start_sigma_rad = 3 * kDegree;
  double look_s = 1;
  double unsure_m = 0.08;
  double lost_m = 0.35;
  double lost_rad = 6 * kDegree;
  double unmatched_max_s = 1.5;
  int unmatched_sightings_min = 3;
  double unmatched_max_m = 3;
  double search_speed_mps = 0.2;
  double search_max_m = 30;
  double give_up_s = 30;
  double off_route_max_m = 1;

  void describe(FieldList& fields);
};

/// The vehicle's pose estimate, for display.
struct LandmarkFix {
  UncertainPose2 T_map_vehicle;
  bool is_sure = false;  ///< it follows its route
  bool is_lost = false;  ///< it is lost, or on its way back onto its route
};

/// Localises at the route's start, then drives the route. Every image that fits the map corrects its pose;
/// without one it goes on by odometry, slower as its uncertainty grows. If the view changes suddenly, it
/// stops and checks whether it is still where it believes to be. It is lost if it is elsewhere, too
/// uncertain, or sees what the map does not contain. Then it stops, relocalises along all routes, and where
/// that is safe explores a few metres of floor to see more; it returns to its route and drives on, or gives
/// up. It waits for obstacles on its route and for its camera, and gives up if that lasts, or where the
/// building's barriers and zones let it go no farther.
class LandmarkNavigator final : public Navigator {
 public:
  /// @param building  with landmarks and the camera that saw them; must outlive the navigator
  /// @param route     of the building, or its return path (Path::reversed)
  /// @throws std::invalid_argument if the vehicle lacks that camera
  LandmarkNavigator(const LandmarkNavigatorParams& params, const VehicleDescription& vehicle,
                    const Building& building, const Path& route);

  Decision step(const Observation& observation) override;

  LandmarkFix fix() const;
  /// Lines in the last image, as landmark sightings; empty in a cycle without an image.
  const std::vector<LandmarkSighting>& sightings() const { return sightings_; }
  const std::vector<VerticalLine>& lines() const { return detector_.lines(); }
  const std::vector<Vec2>& p_vehicle_returns() const { return guard_.p_vehicle_returns(); }
  const LandmarkLocaliser& localiser() const { return localiser_; }

 private:
  enum class State { kLooking, kFollowing, kCheckingConsistency, kLost, kReturning };

  void place(const UncertainPose2& T_map_vehicle);
  void locate(const Observation& observation);
  void look_at(const Image& image);
  void check_for_kidnapping();
  std::string why_lost() const;
  void begin(State state);
  void go_on(State state);
  Decision look_around(double stamp_s);
  Decision check_consistency();
  Decision relocalise(const Observation& observation);
  bool may_search() const;
  Decision search(const Observation& observation);
  Decision found(const Pose2& T_map_vehicle, const Observation& observation);
  Decision return_to_route(const Observation& observation);
  Decision follow(const Observation& observation);
  Decision guarded(Decision decision);

  LandmarkNavigatorParams params_;
  VehicleDescription vehicle_;
  const Building* building_;
  Path path_;
  std::string camera_;
  FloorInImage floor_in_image_;
  LandmarkDetector detector_;
  LandmarkLocaliser localiser_;
  PlaceConsistency consistency_;
  LandmarkRelocator relocator_;
  PathFollower follower_;
  PathProgress progress_;
  ObstacleGuard guard_;
  FloorRules rules_;
  UnmatchedMonitor unmatched_;
  SceneMonitor scenes_;
  StripeMonitor stripes_;
  ContinuityMonitor continuity_;
  ExpectationMonitor expectations_;
  RecognitionMonitor recognition_;
  OdometryMonitor odometry_;
  Pose2 T_map_looked_;  ///< where the last image was taken, as that corrected it
  std::vector<LandmarkSighting> sightings_;
  std::vector<SensedSegment> edges_on_floor_;
  State state_ = State::kLooking;
  State interrupted_ = State::kFollowing;  ///< by the last consistency check
  std::string why_lost_;
  bool was_kidnapped_ = false;  ///< suspected: the view has changed suddenly
  bool has_jumped_ = false;     ///< suspected: walls stand elsewhere, or all lines are gone or new
  bool has_looked_ = false;     ///< this cycle has an image
  std::unique_ptr<ExplorerNavigator> explorer_;  ///< explores the floor around while it is lost
  std::unique_ptr<PathToRoute> path_to_route_;   ///< once it has relocalised off its route
  double searched_m_ = 0;                        ///< distance driven since it was lost
  double searched_s_ = 0;                        ///< when it was lost, or last drove since then
  LandmarkMatch match_ = LandmarkMatch::kNothing;
  std::optional<double> state_since_s_;
  double stamp_s_ = 0;
  double matched_stamp_s_ = 0;  ///< of the last image that fitted, or that showed nothing
};

}  // namespace aisle
