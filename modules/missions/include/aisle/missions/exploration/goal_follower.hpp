#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/guidance/exploration/guide_navigator.hpp"

namespace aisle {

/// What people ask of a vehicle while it drives; each function is asked once a cycle, none may be empty.
struct GoalRequests {
  std::function<std::optional<GoalPlace>()> goal;      ///< a new one, in the map
  std::function<std::optional<Pose2>()> initial_pose;  ///< where somebody says that the vehicle stands
  std::function<void(const std::string&)> say;
};

/// Waits for goals and drives to the newest one, by the shortest free way; see GuideNavigator. A goal that is
/// reached, with its heading or without, has no path to it or is not on known free floor is said, and the
/// next one waited for. A stated pose is believed only if the scans fit the walls there.
class GoalFollower final : public Navigator {
 public:
  /// @param building  a building file's text. The vehicle is believed to be at its home
  /// @return problems as those of GuideDriver::make
  static Result<std::unique_ptr<GoalFollower>> make(const GuideNavigatorParams& params,
                                                    const std::string& building,
                                                    const VehicleDescription& vehicle, GoalRequests requests);

  GoalFollower(const GuideNavigatorParams& params, const VehicleDescription& vehicle, Building building,
               GoalRequests requests);
  GoalFollower(const GoalFollower&) = delete;
  GoalFollower& operator=(const GoalFollower&) = delete;

  Decision step(const Observation& observation) override;

  const GuideNavigator& navigator() const { return navigator_; }
  bool is_finding() const { return false; }  ///< it begins at home
  std::size_t goals() const { return goals_; }
  std::size_t goals_reached() const { return reached_; }

 private:
  /// A pose that was stated, while scans are fitted to the walls there.
  struct PoseCheck {
    Pose2 T_map_stated;
    std::unique_ptr<WallLocaliser> localiser;
    Pose2 T_scan_vehicle;  ///< since the last scan, by odometry
    int scans = 0;
  };

  bool is_free(const Vec2& p_map) const;
  void take_goal(const GoalPlace& goal, double stamp_s);
  void begin_check(const Pose2& T_map_stated);
  void check_pose(const Observation& observation);
  Decision waiting(const std::string& because);

  GuideNavigatorParams params_;
  VehicleDescription vehicle_;
  Building building_;
  GoalRequests requests_;
  GuideNavigator navigator_;
  std::unique_ptr<ScanSource> sensor_;
  std::optional<GoalPlace> goal_;
  std::optional<PoseCheck> check_;
  std::size_t goals_ = 0;
  std::size_t reached_ = 0;
};

}  // namespace aisle
