#pragma once
/// Keeps any navigator from driving into an obstacle.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "aisle/geometry/sensed_segment.hpp"
#include "aisle/guidance/image_monitor.hpp"
#include "aisle/guidance/obstacles/obstacle_memory.hpp"
#include "aisle/guidance/obstacles/path_ahead.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/stripes/stripe_scan.hpp"

namespace aisle {

struct ObstacleGuardParams {
  StripeScanParams stripes;
  ObstacleMemoryParams memory;
  ImageMonitorParams images;
  double margin_m = 0.02;
  double gap_m = 0.8;
  double reach_m = 2.3;
  double deceleration_share = 0.5;
  double reaction_s = 0.4;
  double reverse_speed_mps = 0.15;
  double unlit_s = 2;
  double unlit_speed_mps = 0.1;
  double free_again_s = 0.8;
  double wait_max_s = 20;

  void describe(FieldList& fields);
};

enum class GuardState {
  kFree,     ///< the requested command, or slower because something is ahead
  kWaiting,  ///< stands until the path is free or the camera is back
  kBlocked,  ///< has waited too long: the navigator should give up or turn back
};

struct Guarded {
  Command command;
  GuardState state = GuardState::kFree;
  std::string why;          ///< one line for the user; empty while nothing is in the path
  double free_ahead_m = 0;  ///< free path ahead of the vehicle; at most `reach_m`
};

/// Sits between a navigator and the vehicle. Limits the speed so that the vehicle can stop before the first
/// obstacle in the path of its footprint, and stops it while its camera fails. It detects obstacles by the
/// laser markers' stripe, by the range scanner, and by the floor's edges if a navigator passes them in; a
/// vehicle with none of these is only kept from driving without images. Nothing looks behind, so reversing is
/// slow.
class ObstacleGuard {
 public:
  /// @param camera  to look with; nullptr: none
  ObstacleGuard(const VehicleDescription& vehicle, const ObstacleGuardParams& params,
                const CameraDescription* camera);

  /// Whether it can detect obstacles by itself: with laser markers and a camera, or with a range scanner.
  bool sees_obstacles() const { return stripe_ || vehicle_.scanner; }

  /// Once a cycle, before `allow`.
  /// @return the camera's image if this observation has one that can be trusted (ImageMonitor), else nullptr
  const CameraImage* look(const Observation& observation);

  const OdometryHistory& odometry() const { return odometry_; }

  /// Laser returns in the last image [vehicle frame], in the path or not.
  const std::vector<Vec2>& p_vehicle_returns() const { return sight_.p_vehicle_returns; }

  /// Takes in where the floor ends in the image that `look` has just returned. An obstacle seen this way
  /// counts from the second image in a row on, and only while it is in view, so `gap_m` must keep it there.
  /// @param stamp_s  of the image
  void see_floor(std::span<const SensedSegment> edges, double stamp_s);

  /// Limits a navigator's command to what is safe.
  /// @param path  where `requested` leads to; forwards
  Guarded allow(const Command& requested, const PathAhead& path);

 private:
  /// Laser light in the last image.
  struct Sight {
    double stamp_s = 0;
    Pose2 T_odom_taken;
    std::vector<Vec2> p_vehicle_returns;
    bool is_new = false;
  };
  /// Ends of the floor in the last image.
  struct FloorSight {
    Pose2 T_odom_taken;
    std::vector<Vec2> p_vehicle_end;
    int sightings = 0;  ///< images in a row that show one in the path
    bool is_new = false;
    bool is_used = false;  ///< the navigator passes the floor's edges in
  };

  void read_stripe(const CameraImage& image);
  void take_scan(const RangeScan& scan);
  void remember_what_is_on(const PathAhead& path);
  void judge_floor(const PathAhead& path);
  double free_ahead_m(const PathAhead& path);
  double speed_before(double free_m) const;
  Command limited(const Command& requested) const;
  Guarded waiting(Guarded guarded, const std::string& why);

  VehicleDescription vehicle_;
  ObstacleGuardParams params_;
  OdometryHistory odometry_;
  std::optional<ImageMonitor> monitor_;
  std::optional<StripeScan> stripe_;
  Image grey_;  ///< conversion buffer for coloured images
  ObstacleMemory memory_;
  Sight sight_;
  std::vector<Vec2> p_vehicle_returns_on_path_;
  std::vector<Vec2> p_vehicle_scanned_;
  FloorSight floor_;
  std::optional<double> lit_s_;  ///< when laser light was last seen
  std::optional<double> waiting_from_s_;
  double free_from_s_ = 0;
};

}  // namespace aisle
