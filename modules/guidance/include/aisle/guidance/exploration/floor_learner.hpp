#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "aisle/guidance/exploration/scan_source.hpp"
#include "aisle/learning/walls/online_mapping.hpp"
#include "aisle/maps/floor_view.hpp"
#include "aisle/maps/known_floor.hpp"

namespace aisle {

struct FloorLearnerParams {
  /// Same wall: a door's leaf stands 11 cm behind its wall. Drawn walls: those of a room seen through its
  /// door are visible along a short path only. Submaps: each loop that is closed rebuilds the floor.
  MapParams mapping{.tracker{.motion = kReadEveryCycle, .same_wall_m = 0.06},
                    .loops{.submap_m = 4},
                    .drawn_length_m = 0.3,
                    .drawn_sightings = 2};
  FloorViewParams view;
  LegParams legs;
  double cell_m = 0.05;
  double cell_least_m = 0.025;          ///< cells are halved down to this where a passage is narrow
  double look_every_m = 0.15;           ///< a scan is added to the floor after this path, or ...
  double look_every_rad = 4 * kDegree;  ///< ... after this turn, or ...
  int look_every_cycles = 10;           ///< ... after this time

  void describe(FieldList& fields);
};

/// Maps the floor and localises the vehicle at the same time (SLAM), while it drives.
class FloorLearner {
 public:
  enum class News { kNothing, kFloor, kLoop };  ///< kLoop: the whole floor was rebuilt

  FloorLearner(const FloorLearnerParams& params, const VehicleDescription& vehicle,
               std::unique_ptr<ScanSource> sensor);

  News take(const Observation& observation);

  /// The bumper touched something that no scan shows, at the front or, in reverse, at the rear: the floor
  /// shows it as occupied from now on. Only after the first scan.
  void add_contact(Gear gear);

  /// The vehicle is back home: matches its first scan with the walls that it has seen last, and corrects
  /// `T_map_home`. Only after the first scan.
  void settle_home();

  /// Begins to rebuild the whole floor with cells half as wide, unless they would get narrower than
  /// `cell_least_m`. Not to be called while the floor is being rebuilt.
  /// @return whether it does
  bool halve_cells();

  const Pose2& T_map_vehicle() const { return T_map_vehicle_; }
  const Pose2& T_map_home() const { return T_map_home_; }  ///< start pose, by what is known now
  bool has_looked() const { return !looks_.empty(); }
  const KnownFloor& floor() const { return floor_; }
  const ScanSource& sensor() const { return *sensor_; }
  /// The floor is out of date until it is rebuilt: the vehicle must stand.
  bool is_rebuilding() const { return rebuild_.has_value(); }
  /// The last scan.
  const ScanView& view() const { return view_; }
  /// Distance travelled.
  double path_m() const { return travelled_m_; }
  bool is_standing() const { return is_standing_; }
  /// All scans and the odometry between them, as a log of the run.
  const LaserLog& log() const { return log_; }
  /// One pose per scan, by what is known now.
  std::vector<Pose2> T_map_vehicle_of_all() const { return mapping_.T_map_vehicle_of_all(); }
  /// The floor built with these poses instead, one per scan, without dynamic obstacles.
  FloorGrid floor_from(std::span<const Pose2> T_map_vehicle) const;

 private:
  /// A scan that was added to the floor.
  struct Look {
    std::size_t scan_index = 0;  ///< in the log
    std::vector<float> near_m;
    Viewpoint viewpoint = Viewpoint::kMoved;
    Pose2 T_map_put;  ///< vehicle pose with which it was added
  };
  /// Where the vehicle stood at a bumper contact.
  struct Contact {
    std::size_t scan_index = 0;  ///< last scan before it ...
    Pose2 T_scan_vehicle;        ///< ... and the vehicle's motion since
    Gear gear = Gear::kForward;
    Pose2 T_map_put;  ///< vehicle pose with which it was added
  };
  /// The floor after a loop closure, or with narrower cells, while it is being built.
  struct Rebuild {
    KnownFloor floor;
    std::size_t next = 0;  ///< index in `looks_`
  };

  Viewpoint viewpoint() const;
  bool is_time_to_look() const;
  bool hits_something_new() const;
  FloorBox put(const Look& look, const Pose2& T_map_vehicle, FloorGrid& floor) const;
  FloorBox put(const Contact& contact, const Pose2& T_map_vehicle, FloorGrid& floor) const;
  void keep_scan(double stamp_s);
  Footprint initial_free_area() const;
  bool places_moved();
  void begin_rebuild();
  bool continue_rebuild();
  FloorBox put_contacts_again(FloorGrid& grid);

  FloorLearnerParams params_;
  VehicleDescription vehicle_;
  std::unique_ptr<ScanSource> sensor_;
  OnlineMapping mapping_;
  KnownFloor floor_;
  std::optional<Rebuild> rebuild_;
  double cell_m_;
  std::vector<Pose2> T_map_of_all_;  ///< one per scan, when the floor was last rebuilt
  ScanView view_;
  std::vector<Look> looks_;
  std::vector<Contact> contacts_;
  LaserLog log_;
  int cycles_since_look_ = 0;
  Pose2 T_odom_vehicle_;
  Pose2 T_scan_vehicle_;  ///< since the last scan, by odometry
  Pose2 T_map_vehicle_;
  Pose2 T_map_home_;
  Pose2 T_map_looked_;
  double travelled_m_ = 0;
  bool is_standing_ = true;
};

}  // namespace aisle
