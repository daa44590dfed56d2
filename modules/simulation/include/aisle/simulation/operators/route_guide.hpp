#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aisle/simulation/operators/scripted_operator.hpp"

namespace aisle {

/// The route of a world by its name; nullptr: there is none.
const WorldRoute* route_of(const World& world, const std::string& name);

/// Where a vehicle starts to be shown a route: at the route's start, facing along it.
Pose2 start_of(const WorldRoute& route);

/// What a person shows of a taught place besides the path to it.
enum class ShownViews {
  kTrail,   ///< nothing more
  kPattern  ///< views from around it, as L96 Algorithm 3 requires
};

/// Drives a vehicle along a route of its world, and marks where its turnings begin and end and how to park at
/// the end (L96 Algorithm 1). To show views of a taught place, it then drives to and fro around it, forwards
/// on the lanes of the pattern (maps/view_pattern.hpp) and backwards from lane to lane. Lanes without enough
/// clearance are left out.
class RouteGuide final : public Operator {
 public:
  /// @param route  of the world
  RouteGuide(const World& world, const WorldRoute& route, const VehicleDescription& vehicle,
             const ScriptedOperatorParams& params, std::uint64_t seed, ShownViews views = ShownViews::kTrail);

  OperatorInput look(const OperatorView& view) override;
  bool has_arrived() const { return has_shown_path_; }

 private:
  struct TurningMark {
    double along_m = 0;
    Mark mark;
  };

  WorldRoute route_;
  std::vector<Vec2> about_place_;  ///< where it turns back, after the path
  ScriptedOperator driver_;
  bool has_shown_path_ = false;
  std::vector<TurningMark> marks_;  ///< not yet given, in order
  double along_m_ = 0;
};

}  // namespace aisle
