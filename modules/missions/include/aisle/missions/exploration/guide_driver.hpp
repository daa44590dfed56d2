#pragma once
/// Makes the navigator of `go` and `patrol` for missions and for their replays, both from the origin that the
/// session records.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/exploration/guide_navigator.hpp"
#include "aisle/guidance/exploration/place_finder.hpp"
#include "aisle/maps/corridor_path.hpp"

namespace aisle {

/// Where a mission in a building begins.
struct MissionStart {
  bool is_unknown = false;          ///< the vehicle is to find itself, wherever it stands
  std::optional<Pose2> T_map_hint;  ///< somebody says that it is about here: checked

  /// Neither: at home.
  bool is_home() const { return !is_unknown && !T_map_hint; }
};

/// Where a vehicle is sent in a building.
struct Goal {
  std::vector<GoalPlace> places;  ///< in order
  double shortest_m = 0;          ///< length of the shortest path along the corridors, from home
  /// Of each place, empty for a point. Of a patrol none: nobody asked for its places.
  std::vector<std::string> names = {};

  bool is_queue() const { return names.size() > 1; }
};

/// Goal at one place: the name of a place, with its heading if it has one, or of a corridor node ("crossing
/// 2", "end 1"), or "x,y" in the map [m], or "x,y,heading_deg". An unknown name is a problem that lists the
/// known ones.
Result<Goal> goal_to(const Building& building, const std::string& place);

/// Goal at one place after the other; the problems are those of all of them.
/// @param places  as in goal_to(), at least one
Result<Goal> goal_through(const Building& building, const std::vector<std::string>& places);

/// {"goals":[{"place":"desk"},{"x_m":1,"y_m":2,"heading_deg":90}],"reached":1}; a patrol has no goals.
std::string goals_json(const Goal& goal, std::size_t reached);

/// Goal along all corridors, `rounds` times, and home again, with its heading.
Result<Goal> patrol_goal(const Building& building, int rounds);

/// Why goals in a building cannot be driven to: it has no walls, floor or corridors, the vehicle no scanner.
Problems check_guidable(const Building& building, const VehicleDescription& vehicle);

/// Owns the building that its navigator drives in.
class GuideDriver final : public Navigator {
 public:
  static constexpr const char* kName = "guide";  ///< name of the navigator in a session

  /// The goal of a session that drives to these places in order: "go PLACE", or "goals" and a JSON list.
  static std::string go_text(const std::vector<std::string>& places);

  /// What a session records of it. The caller sets the seed.
  /// @param building  the text of a building file
  /// @param goal    from go_text(), or "patrol ROUNDS"
  static SessionOrigin origin(const GuideNavigatorParams& params, std::string building, std::string goal,
                              const MissionStart& start = {});

  /// Problems: parameters and building that cannot be read, a building without walls, floor or corridors, an
  /// unknown place, a vehicle without a range scanner.
  static Result<std::unique_ptr<GuideDriver>> make(const SessionOrigin& origin,
                                                   const VehicleDescription& vehicle);

  GuideDriver(const GuideNavigatorParams& params, const VehicleDescription& vehicle, Building building,
              Goal goal, const MissionStart& start = {});
  GuideDriver(const GuideDriver&) = delete;
  GuideDriver& operator=(const GuideDriver&) = delete;

  /// Finds the vehicle first, unless it begins at home, and again where it is lost on its way. Goals that the
  /// observation's operator adds or takes out are obeyed, unless they are unknown, reached, or the last one.
  Decision step(const Observation& observation) override;

  const Building& building() const { return building_; }
  const Goal& goal() const { return goal_; }
  const GuideNavigator& navigator() const { return navigator_; }
  /// Nobody knows where the vehicle is; the navigator waits.
  bool is_finding() const { return finder_ != nullptr; }
  std::size_t times_lost() const { return times_lost_; }

 private:
  void take(const GoalChange& change, double stamp_s);
  Decision find(const Observation& observation);
  Decision guide(const Observation& observation);
  void begin_finding(const std::optional<Pose2>& T_map_hint);

  VehicleDescription vehicle_;
  Building building_;
  Goal goal_;
  GuideNavigator navigator_;
  std::unique_ptr<PlaceFinder> finder_;  ///< until the vehicle is found
  std::size_t times_lost_ = 0;
};

}  // namespace aisle
