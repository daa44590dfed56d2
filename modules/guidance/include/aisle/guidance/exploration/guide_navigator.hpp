#pragma once
/// Goal navigation: drives to places in a building that was explored before.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/guidance/exploration/goal_place.hpp"
#include "aisle/guidance/exploration/scan_source.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/guidance/obstacles/floor_rules.hpp"
#include "aisle/guidance/paths/path_driver.hpp"
#include "aisle/guidance/paths/staged_search.hpp"
#include "aisle/learning/walls/wall_localiser.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/maps/floor_view.hpp"
#include "aisle/maps/known_floor.hpp"

namespace aisle {

struct GuideNavigatorParams {
  WallLocaliserParams localiser;
  FloorViewParams view;
  LegParams legs;
  CarSearchParams search;
  SteeringParams steering;
  SpeedParams speed{.speed_mps = 0.4};
  double start_sigma_m = 0.1;
  double start_sigma_rad = 3 * kDegree;
  double look_s = 1;
  double look_every_m = 0.15;
  double look_every_s = 0.5;
  double arrive_m = 0.4;
  double lost_s = 5;
  double give_up_s = 40;
  int expansions = 1000;

  void describe(FieldList& fields);
};

/// Localises by the building's walls, plans on the learned floor, updated by what it sees now, and drives to
/// one place after the other. It detours around obstacles, through other corridors if need be, and around the
/// building's barriers, and obeys its zones. Where no path is left it waits, and finally gives up. At a place
/// that has a heading it turns to that, where there is room to; else it says how far off it stands.
class GuideNavigator final : public Navigator {
 public:
  /// So near to a place's heading it counts as reached.
  static constexpr double kFacing_rad = 10 * kDegree;

  /// @param building       with walls and floor; must outlive the navigator
  /// @param T_map_start    approximate pose of the vehicle
  /// @param places         goals, in this order
  /// @throws std::invalid_argument if the building has no floor
  GuideNavigator(const GuideNavigatorParams& params, const VehicleDescription& vehicle,
                 const Building& building, const Pose2& T_map_start, std::vector<GoalPlace> places,
                 std::unique_ptr<ScanSource> sensor);

  Decision step(const Observation& observation) override;

  /// Other places, instead of those that it has not reached; none: it stands.
  void send_to(std::vector<GoalPlace> places, double stamp_s);
  /// One more place, behind the last.
  void add_place(const GoalPlace& place) { places_.push_back(place); }
  /// It drives to the others only. @param place  index of one that it has not reached
  void remove_place(std::size_t place, double stamp_s);
  /// It is somewhere else than it believed.
  void relocate(const Pose2& T_map_vehicle, double stamp_s);
  /// The vehicle is here, as somebody has found out. What it saw before may have been elsewhere: the floor is
  /// again as it was learned.
  void begin_at(const UncertainPose2& T_map_vehicle, double stamp_s);
  /// What it sees has fitted no walls that it knows for `lost_s`; its last decision was to fail.
  bool is_lost(double stamp_s) const { return stamp_s - localised_s_ > params_.lost_s; }

  const Pose2& T_map_vehicle() const { return T_map_vehicle_; }
  const WallLocaliser& localiser() const { return localiser_; }
  std::size_t places_reached() const { return next_; }
  /// How it stood at the places reached that have a heading.
  const std::vector<GoalHeading>& headings() const { return headings_; }
  /// How often a path was dropped because it was no longer free.
  std::size_t ways_closed() const { return ways_closed_; }
  /// The path that it follows; empty while it stands.
  const Path& path() const { return driver_.path(); }
  /// The floor as it is known now.
  const KnownFloor& floor() const { return floor_; }

 private:
  /// How far it is with the heading of the next place.
  struct HeadingProgress {
    int turns_tried = 0;            ///< at the place
    bool has_turned_fully = false;  ///< on the spot, to exactly the heading
    bool is_ignored = false;        ///< until it is at the place: no path to the heading there was found
  };

  Decision decide(const Observation& observation);
  void locate(const Observation& observation);
  void look_at_floor(double stamp_s);
  void check_path();
  void begin_search();
  void search_path(double stamp_s);
  void search_again(double stamp_s);
  bool is_at_place(const Pose2& T_map_vehicle) const;
  bool seeks_heading() const { return places_[next_].heading_rad && !facing_.is_ignored; }
  double off_heading_rad(const Pose2& T_map_vehicle) const;
  void begin_place(double stamp_s);
  bool arrive_facing(double stamp_s);
  void give_up_heading(double stamp_s);
  void reach_place(double stamp_s);
  std::string missed_headings() const;
  void drop_path();
  Decision drive(const Observation& observation);
  std::string why_failed(const Observation& observation);

  GuideNavigatorParams params_;
  VehicleDescription vehicle_;
  std::unique_ptr<ScanSource> sensor_;
  const Building& building_;
  WallLocaliser localiser_;
  KnownFloor floor_;
  StagedSearch search_;
  PathDriver driver_;
  FloorRules rules_;
  std::vector<GoalPlace> places_;
  std::size_t next_ = 0;  ///< index in `places_`
  std::vector<GoalHeading> headings_;
  HeadingProgress facing_;
  ScanView view_;
  Pose2 T_scan_vehicle_;  ///< since the last scan, by odometry
  Pose2 T_map_vehicle_;
  Pose2 T_map_looked_;
  std::optional<double> begun_s_;
  double looked_s_ = 0;
  double localised_s_ = 0;                     ///< when it last knew where it was
  double progress_s_ = 0;                      ///< when it last got on
  Vec2 p_map_progress_ = Vec2::Constant(1e9);  ///< where that was
  double searched_s_ = 0;
  std::optional<LegDirection> blocked_direction_;  ///< in which the vehicle could just not go on
  bool relaxes_clearance_ = false;                 ///< through less room, as the search before found no path
  std::size_t ways_closed_ = 0;
};

}  // namespace aisle
