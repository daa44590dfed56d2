#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "aisle/guidance/exploration/scan_source.hpp"
#include "aisle/learning/walls/online_mapping.hpp"
#include "aisle/maps/floor_clearance.hpp"
#include "aisle/maps/floor_view.hpp"

namespace aisle {

struct FloorLearnerParams {
  /// Doors' leaves stand 11 cm behind their walls. The wheels are the vehicle's own, and count the right way.
  /// Of a room that was looked into from its door, walls are seen on a short path.
  MapParams mapping{.tracker{.motion = kReadEveryCycle, .same_wall_m = 0.06, .may_count_backwards = false},
                    .drawn_length_m = 0.3,
                    .drawn_sightings = 2};
  FloorViewParams view;
  LegParams legs;
  double cell_m = 0.05;
  double cell_least_m = 0.025;          ///< so narrow they may become where need be
  double look_every_m = 0.15;           ///< of path, or ...
  double look_every_rad = 4 * kDegree;  ///< ... of turning, or ...
  int look_every_cycles = 10;           ///< ... of time the floor is looked at

  void describe(FieldList& fields);
};

/// Learns where the vehicle is and what floor there is, both at once, while it drives.
class FloorLearner {
 public:
  enum class News { kNothing, kFloor, kLoop };  ///< kLoop: the whole floor was laid again

  FloorLearner(const FloorLearnerParams& params, const VehicleDescription& vehicle,
               std::unique_ptr<ScanSource> sensor);

  News take(const Observation& observation);

  /// The vehicle touches something that no scan shows, before its front (1) or behind its rear (-1): from
  /// now on something stands there on the floor. After the first scan.
  void touch(int direction);

  /// Back where it began, by what it sees from there: lays its first scan onto the walls that it has come by
  /// last. After the first scan.
  void settle_home();

  /// Lays the whole floor again, on cells half as wide, unless that is less than they may be. Not while it is
  /// laid again.
  /// @return whether it does
  bool halve_cells();

  const Pose2& T_map_vehicle() const { return T_map_vehicle_; }
  const Pose2& T_map_home() const { return T_map_home_; }  ///< where it began, as known now
  bool has_looked() const { return !looks_.empty(); }
  const FloorGrid& floor() const { return floor_; }
  const FloorClearance& clearance() const { return clearance_; }
  const ScanSource& sensor() const { return *sensor_; }
  /// The floor does not lie yet where it belongs: no time to drive.
  bool is_laying_again() const { return again_.has_value(); }
  /// What the sensor showed last.
  const ScanView& view() const { return view_; }
  double path_m() const { return travelled_m_; }
  bool is_standing() const { return is_standing_; }
  /// All scans and the odometry between them, as a log of the run.
  const LaserLog& log() const { return log_; }
  /// One a scan, as known now.
  std::vector<Pose2> T_map_vehicle_of_all() const { return mapping_.T_map_vehicle_of_all(); }
  /// The floor as all that was looked at shows it from these poses, one a scan.
  FloorGrid floor_from(std::span<const Pose2> T_map_vehicle) const;

 private:
  /// A scan that was put onto the floor.
  struct Look {
    std::size_t scan_index = 0;  ///< of the log
    std::vector<float> near_m;
    Pose2 T_map_put;  ///< of the vehicle, where the floor shows it
  };
  /// Where the vehicle stood when it touched something.
  struct Touch {
    std::size_t scan_index = 0;  ///< the latest one then ...
    Pose2 T_scan_vehicle;        ///< ... and where the vehicle had come since
    int direction = 0;
    Pose2 T_map_put;  ///< of the vehicle, where the floor shows it
  };
  /// The floor after a place was recognised, or of narrower cells, while it is made.
  struct LaidAgain {
    LaidAgain(double cell_m, double far_m, const LegParams& legs) : floor(cell_m), clearance(legs, far_m) {}
    FloorGrid floor;
    FloorClearance clearance;
    std::size_t next = 0;  ///< of the looks
  };

  bool is_time_to_look() const;
  bool strikes_something_new() const;
  FloorBox put(const Look& look, const Pose2& T_map_vehicle, FloorGrid& floor) const;
  FloorBox put(const Touch& touch, const Pose2& T_map_vehicle, FloorGrid& floor) const;
  void keep_scan(double stamp_s);
  Footprint set_down_room() const;
  bool places_moved();
  void begin_again();
  bool lay_on();

  FloorLearnerParams params_;
  VehicleDescription vehicle_;
  std::unique_ptr<ScanSource> sensor_;
  OnlineMapping mapping_;
  FloorGrid floor_;
  FloorClearance clearance_;
  std::optional<LaidAgain> again_;
  double cell_m_;
  std::vector<Pose2> T_map_of_all_;  ///< when the floor was laid again last
  ScanView view_;
  std::vector<Look> looks_;
  std::vector<Touch> contacts_;
  LaserLog log_;
  int cycles_since_look_ = 0;
  Pose2 T_odom_vehicle_;
  Pose2 T_scan_vehicle_;  ///< since the latest scan, by odometry
  Pose2 T_map_vehicle_;
  Pose2 T_map_home_;
  Pose2 T_map_looked_;
  double travelled_m_ = 0;
  bool is_standing_ = true;
};

}  // namespace aisle
