#pragma once
/// Keeps any navigator from driving against something.

#include <array>
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
#include "aisle/vision/stripes/stripe_fan.hpp"

namespace aisle {

struct ObstacleGuardParams {
  StripeFanParams stripes;
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
  kFree,     ///< the wished command, or slower because something is ahead
  kWaiting,  ///< stands until the path is free or the camera is back
  kBlocked,  ///< has waited too long: the navigator should give up or turn back
};

struct Guarded {
  Command command;
  GuardState state = GuardState::kFree;
  std::string why;          ///< one line for people; empty while nothing is in the path
  double free_ahead_m = 0;  ///< that the vehicle can go; at most `reach_m`
};

/// Stands between a navigator and the vehicle: lets the vehicle go only as fast as it can stop before the
/// first thing that stands where its footprint will be, and only while its camera shows what is there. It
/// sees things by the laser markers' stripe, by the range scanner, and by the floor's edges where a navigator
/// finds them; a vehicle with none of these is only kept from driving without images. Nothing sees behind:
/// reversing is slow.
class ObstacleGuard {
 public:
  /// @param camera  to look with; null: none
  ObstacleGuard(const VehicleDescription& vehicle, const ObstacleGuardParams& params,
                const CameraDescription* camera);

  /// Whether it has the means to: laser markers in view of its camera, or a range scanner.
  bool sees_obstacles() const { return stripe_ || vehicle_.scanner; }

  /// Once a cycle, before `allow`.
  /// @return the camera's image if it has come in time, is not the one before again, and shows something
  const CameraImage* look(const Observation& observation);

  /// Where the last image shows laser light [vehicle frame], on the way or not.
  const std::vector<Vec2>& p_vehicle_lit() const { return sight_.p_vehicle_lit; }

  /// Takes in where the floor ends in the image that `look` has just returned. A thing that is seen so
  /// counts from the second image in a row on, and as long as it is in view: `gap_m` must leave it there.
  void see_floor(std::span<const SensedSegment> edges);

  /// What the vehicle may do of what a navigator requests.
  /// @param path  where `wished` leads to; forwards
  Guarded allow(const Command& wished, const PathAhead& path);

 private:
  struct StampedPose {
    double stamp_s = 0;
    Pose2 T_odom_vehicle;
  };
  /// What the last image shows of laser light.
  struct Sight {
    StampedPose taken;
    std::vector<Vec2> p_vehicle_lit;
    bool is_new = false;
  };
  /// What the last image shows of the floor's end.
  struct FloorSight {
    StampedPose taken;
    std::vector<Vec2> p_vehicle_end;
    int sightings = 0;  ///< images in a row that show it on the way
    bool is_new = false;
    bool is_used = false;  ///< at all
  };

  void move(const Observation& observation);
  StampedPose taken_at(double stamp_s) const;
  void read_stripe(const CameraImage& image);
  void take_scan(const RangeScan& scan);
  void remember_what_is_on(const PathAhead& path);
  void judge_floor(const PathAhead& path);
  double free_ahead_m(const PathAhead& path);
  double speed_before(double free_m) const;
  Command limited(const Command& wished) const;
  Guarded waiting(Guarded guarded, const std::string& why);

  VehicleDescription vehicle_;
  ObstacleGuardParams params_;
  std::optional<ImageMonitor> watch_;
  std::optional<StripeFan> stripe_;
  Image grey_;  ///< of coloured images
  ObstacleMemory memory_;
  std::array<StampedPose, 16> poses_;
  std::size_t moves_ = 0;
  StampedPose now_;
  Sight sight_;
  std::vector<Vec2> p_vehicle_lit_on_path_;
  std::vector<Vec2> p_vehicle_scanned_;
  FloorSight floor_;
  std::optional<double> lit_s_;  ///< when laser light was seen last
  std::optional<double> waiting_from_s_;
  double free_from_s_ = 0;
};

}  // namespace aisle
