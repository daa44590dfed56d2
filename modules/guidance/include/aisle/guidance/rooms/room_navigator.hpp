#pragma once
/// Drives a taught path through a room: L96 Algorithm 5.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/control/path_progress.hpp"
#include "aisle/guidance/image_monitor.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/guidance/obstacles/floor_rules.hpp"
#include "aisle/guidance/rooms/corner_backing.hpp"
#include "aisle/guidance/rooms/edge_memory.hpp"
#include "aisle/guidance/rooms/edge_place.hpp"
#include "aisle/guidance/rooms/frame_backing.hpp"
#include "aisle/guidance/rooms/frame_parking.hpp"
#include "aisle/guidance/rooms/free_steering.hpp"
#include "aisle/guidance/rooms/odometry_calibration.hpp"
#include "aisle/guidance/rooms/place_parking.hpp"
#include "aisle/guidance/rooms/stop_view_matcher.hpp"
#include "aisle/maps/route.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {

struct RoomNavigatorParams {
  RouteViewParams view;
  FreeSteeringParams steering;
  ImageMonitorParams images;
  CornerBackingParams corner_backing;
  FrameParkingParams frame;
  FrameBackingParams frame_backing;
  StopViewParams stop_views;
  EdgePlaceParams place;
  PlaceParkingParams taught_place;
  double speed_mps = 0.3;
  double turning_speed_mps = 0.2;
  double parking_speed_mps = 0.12;
  double look_ahead_m = 0.8;
  double middle_share = 0.4;
  double turning_middle_share = 0.15;
  double place_from_m = 4;
  double taught_alone_m = 2;
  double end_comfort_m = 0.1;
  double avoid_rad = 30 * kDegree;
  bool avoid_as_published = true;
  double dead_end_share = 1.0 / 3;
  double dead_end_gap_m = 0.4;
  int dead_end_images = 3;
  double dead_end_beyond_m = 0.3;
  double frame_within_m = 3.5;
  double frame_astray_m = 1;
  double brightness_tolerance = 0.35;
  double brightness_gain = 0.05;
  double hidden_max_m = 0.8;
  double stop_free_m = 0.15;
  double wait_s = 3;
  double back_off_m = 0.6;
  int back_offs_max = 4;
  double pattern_share_max = 0.25;
  double blind_max_s = 10;

  void describe(FieldList& fields);
};

/// Follows the taught path, and keeps to the middle of the free floor that the first camera sees; in a
/// turning, to the middle of the part that is not masked. Steers away from obstacles that are too near, waits
/// before what blocks the path, backs off towards the taught path and tries again. Between two close turnings
/// it reverses as taught, until it sees the corner of the route. At the end it parks as the route says.
/// `middle_share` weighs the route's middle against the taught path, which is followed by odometry; 1 is as
/// published.
class RoomNavigator final : public Navigator {
 public:
  /// @throws std::invalid_argument if the vehicle lacks a camera that the route needs (room_cameras.hpp), or
  ///         the route was not taught in a room
  /// @param from_m  about where on the route the vehicle stands
  /// @param rules   of the building that the route belongs to
  RoomNavigator(const RoomNavigatorParams& params, const VehicleDescription& vehicle, Route route,
                double from_m = 0, FloorRules rules = {});

  Decision step(const Observation& observation) override;

  /// Progress on the taught route.
  const PathPoint& point() const { return progress_.point(); }
  /// Pose in the frame of the taught route.
  Pose2 pose() const { return place_.T_map_odom() * T_odom_vehicle(); }
  const std::optional<RouteSight>& sight() const { return view_.sight(); }
  const RouteView& view() const { return view_; }
  const EdgeMemory& edges() const { return edges_; }
  /// Whether edges or views have confirmed the parking place; always true unless it parks by views.
  bool has_confirmed_place() const;
  /// Whether it saw the corner of the route when it last reversed between turnings; nullopt: it did not
  /// reverse by a corner.
  std::optional<bool> has_seen_corner() const;
  /// What the wheels misreport, if it is sure of that.
  std::optional<OdometryCorrection> odometry_correction() const;
  /// Number of attempts to park.
  int parking_tries() const;

 private:
  enum class State {
    kFollowing,
    kBackingOff,
    kBackingBetweenTurnings,
    kParkingInFrame,
    kBackingIntoFrame,
    kLeavingPlace
  };

  static constexpr double kReach_m = 4;  ///< of its memory

  const Pose2& T_odom_vehicle() const { return odometry_.T_odom_vehicle(); }
  Decision decide(const Observation& observation);
  void look(const Observation& observation);
  void calibrate(double stamp_s);
  double relative_brightness() const;
  bool knows_path_ahead() const;
  void find_place();
  Decision follow(double now_s);
  Decision park_in_frame(double now_s);
  Decision back_into_frame(double now_s);
  void look_for_frame(const Observation& observation);
  Pose2 T_map_taught_frame() const;
  Pose2 T_map_odom_by_frame() const;
  void learn_floor_before_frame();
  void forget_frame_lines();
  Decision unless_obstructed(Decision decision, double now_s);
  Decision back_off(double now_s);
  Decision leave_place();
  Decision slipping() const;
  Decision blocked(double now_s);
  std::string why_waiting() const;
  std::string why_blocked() const;
  bool is_on_path_back() const;
  bool has_path_back_next() const;
  void begin_path_back();
  Decision back_between_turnings();
  void remember_driven();
  void learn_floor_behind();
  std::vector<Vec2> standing_behind() const;
  SteeringChoice choose_steering_behind(double requested_rad) const;
  Decision drive(const SteeringChoice& choice, double speed_mps, const std::string& state) const;
  double requested_steering_rad() const;
  /// Near the taught end, with a confirmed pose: only the taught path counts.
  bool keeps_to_taught_end() const;
  std::optional<double> avoiding_rad() const;
  double steering_to(const Vec2& p_vehicle) const;
  double gap_ahead_m() const;
  /// Whether an obstacle has been seen where a vehicle at the route's end would stand.
  bool is_place_taken() const;
  bool is_at_dead_end() const;
  bool is_beyond_dead_end() const;
  void begin_to_back_off();
  SteeringChoice choose_path_back() const;
  std::optional<Decision> arrived();
  double left_m() const { return route_.path.length_m() - progress_.point().along_m; }
  double left_to_end_m() const;

  RoomNavigatorParams params_;
  VehicleDescription vehicle_;
  Route route_;
  RouteView view_;
  OdometryCalibration calibration_;
  OdometryHistory odometry_;
  ImageMonitor monitor_;
  EdgeMemory edges_;
  EdgePlace place_;
  PathProgress progress_;
  std::unique_ptr<FrameParking> frame_;
  std::unique_ptr<FrameBacking> frame_backing_;
  std::unique_ptr<CornerBacking> corner_backing_;  ///< for a route with reverse paths between turnings
  bool backs_to_corner_ = false;                   ///< else as taught
  double back_to_m_ = 0;                           ///< along the route, the end of such a reverse path
  StopViewMatcher stop_views_;
  RouteBrightness brightness_;
  bool is_brightness_off_ = false;  ///< the brightness ahead does not match the route's
  Pose2 T_odom_seen_;               ///< where the last image was taken that matched
  State state_ = State::kFollowing;
  int dead_end_images_ = 0;        ///< images in a row that showed one
  std::optional<double> blind_s_;  ///< since when it has had no good image
  std::optional<double> stopped_s_;
  Pose2 T_odom_stopped_;
  PlaceParking taught_place_;
  double pattern_share_;  ///< share of the taught path where the floor's pattern looked like obstacles
  double steering_rad_ = 0;
  double commanded_mps_ = 0;          ///< in the last cycle
  std::vector<Pose2> T_odom_driven_;  ///< poses of this run, near the vehicle
  std::vector<Vec2> p_map_limit_;     ///< limit of the known floor, for reversing
  SteeringChoice path_back_;
  int back_offs_ = 0;  ///< near one place
  double back_offs_at_m_ = 0;
  FloorRules rules_;
};

}  // namespace aisle
