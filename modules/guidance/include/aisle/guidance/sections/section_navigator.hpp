#pragma once
/// Drives a list of sections, each by its own guidance: L03 section 4.

#include <optional>
#include <string>
#include <vector>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/guidance/obstacles/floor_rules.hpp"
#include "aisle/guidance/obstacles/obstacle_guard.hpp"
#include "aisle/guidance/sections/guided_path.hpp"
#include "aisle/guidance/sections/section_localiser.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/floor/floor_edges.hpp"

namespace aisle {

struct SectionNavigatorParams {
  FloorEdgeParams floor_edges{.looks_past = 2};
  SteeringParams steering;
  SpeedParams speed{.speed_mps = 0.1};
  ObstacleGuardParams guard{.margin_m = 0.03, .gap_m = 0.25, .reach_m = 1};
  bool guarded = true;
  double look_s = 0.5;
  SectionLocaliserParams localiser;
  double lost_m = 0.3;

  void describe(FieldList& fields);
};

/// Follows the path by its localiser's pose, and waits before obstacles on the floor ahead. At the end it
/// turns on the spot to its final heading and checks that by a last look. Home again, it stops at the pose at
/// which it really started, by all that it saw, not where the list begins. It gives up if its lateral
/// uncertainty gets too large, if it waits for too long, or if the bumper is pressed, and reports where in
/// the list.
class SectionNavigator final : public Navigator {
 public:
  /// @param camera  name of the vehicle's camera that looks along the corridor
  /// @param rules   of the building that the path lies in
  /// @throws std::invalid_argument if the vehicle has none of that name, or the path is empty
  SectionNavigator(const SectionNavigatorParams& params, const VehicleDescription& vehicle,
                   const std::string& camera, SectionList sections, GuidedPath guided, FloorRules rules = {});
  SectionNavigator(const SectionNavigator&) = delete;
  SectionNavigator& operator=(const SectionNavigator&) = delete;

  Decision step(const Observation& observation) override;

  const Pose2& pose() const { return localiser_.pose(); }
  const Path& path() const { return guided_.path; }
  bool comes_home() const { return guided_.comes_home; }
  const SectionGuide& guide() const { return guided_.guides[progress_.point().piece]; }
  const PathPoint& point() const { return progress_.point(); }
  /// The floor's edges in the last image.
  const std::vector<FloorEdge>& edges() const { return edges_; }

 private:
  Decision decide(const Observation& observation);
  void locate(const Observation& observation);
  Pose2 pose_on_path() const;
  Decision take_last_heading(double stamp_s);
  Decision guarded(Decision decision);
  std::string place() const;
  Decision fail(std::string state, const std::string& what) const;

  SectionNavigatorParams params_;
  VehicleDescription vehicle_;
  std::string camera_;
  SectionList sections_;
  GuidedPath guided_;
  FloorEdgeDetector detector_;
  SectionLocaliser localiser_;
  PathFollower follower_;
  PathProgress progress_;
  ObstacleGuard guard_;
  FloorRules rules_;
  std::vector<FloorEdge> edges_;
  std::vector<SensedSegment> edges_on_floor_;
  bool is_guided_ = false;  ///< in this cycle
  std::optional<double> begun_s_;
  std::optional<double> headed_s_;  ///< since when it has its final heading
};

}  // namespace aisle
