#pragma once
/// Drives a list of sections, each in its own way: L03 section 4.

#include <optional>
#include <string>
#include <vector>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/learning/pose_filter.hpp"
#include "aisle/learning/walls_beside.hpp"
#include "aisle/maps/section.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/floor_edges.hpp"

namespace aisle {

/// What a piece of a path is driven by.
struct SectionGuide {
  std::size_t section = 0;  ///< of the list
  bool follows = false;     ///< along a base line, at these distances
  std::optional<double> right_m;
  std::optional<double> left_m;
};

struct GuidedPath {
  Path path;
  std::vector<SectionGuide> guides;  ///< one a piece
};

enum class SectionTrip { kThere, kBack, kThereAndBack };

/// The way of a list; back, the vehicle turned about, right and left change places.
GuidedPath guided_path(const SectionList& sections, const Pose2& T_map_start, SectionTrip trip);

struct SectionNavigatorParams {
  FloorEdgeParams floor_edges;
  SteeringParams steering;
  SpeedParams speed{.speed_mps = 0.1};
  double look_s = 0.5;
  double start_sigma_m = 0.05;
  double start_sigma_rad = 3 * kDegree;
  double wall_sigma_m = 0.03;
  double wall_gate_m = 0.25;
  double repeat_inflation = 3;
  double lost_m = 0.3;
  bool heading_by_walls = true;
  bool left_base_line = true;

  void describe(FieldList& fields);
};

/// Keeps to the way by its odometry, corrected by what it sees: beside sections that follow a base line, the
/// distance of the right one (of the left one where that is not seen); everywhere, its heading by floor edges
/// in a building of right angles, which replaces L03's plain dead reckoning. Too unsure how far aside of its
/// way it is, or with the bumper pressed, it gives up, and says where in the list.
class SectionNavigator final : public Navigator {
 public:
  /// @param camera  the vehicle's, that looks along the corridor
  /// @throws std::invalid_argument if the vehicle has none of that name, or the path is empty
  SectionNavigator(const SectionNavigatorParams& params, const VehicleDescription& vehicle,
                   const std::string& camera, SectionList sections, GuidedPath way);

  Decision step(const Observation& observation) override;

  const Pose2& pose() const { return filter_.pose(); }
  const Path& path() const { return way_.path; }
  const SectionGuide& guide() const { return way_.guides[progress_.point().piece]; }
  const PathPoint& point() const { return progress_.point(); }

 private:
  void locate(const Observation& observation);
  void correct_heading();
  void correct_distance();
  const WallBeside* wall_at(double aside_m) const;
  double aside_sigma_m() const;
  std::string place() const;
  Decision fail(std::string state, const std::string& what) const;

  SectionNavigatorParams params_;
  VehicleDescription vehicle_;
  std::string camera_;
  SectionList sections_;
  GuidedPath way_;
  FloorEdgeDetector detector_;
  PoseFilter filter_;
  PathFollower follower_;
  PathProgress progress_;
  std::vector<SensedSegment> edges_;
  std::vector<WallBeside> beside_;
  bool is_guided_ = false;  ///< in this cycle
  std::optional<double> begun_s_;
};

}  // namespace aisle
