#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aisle/simulation/scripted_operator.hpp"

namespace aisle {

/// The route of a world by its name; nullptr: there is none.
const TaughtWay* route_of(const World& world, const std::string& name);

/// Where a vehicle stands that is to be shown a route: at its start, facing along it.
Pose2 start_of(const TaughtWay& route);

/// Drives a vehicle along a route of its world, and says where its turnings begin and end and how to park at
/// the end (L96 Algorithm 1).
class RouteGuide final : public Operator {
 public:
  /// @param route  of the world
  RouteGuide(const World& world, const TaughtWay& route, const VehicleDescription& vehicle,
             const ScriptedOperatorParams& params, std::uint64_t seed);

  OperatorInput look(const OperatorView& view) override;
  bool has_arrived() const { return driver_.has_arrived(); }

 private:
  struct TurningMark {
    double along_m = 0;
    Mark mark;
  };

  TaughtWay route_;
  ScriptedOperator driver_;
  std::vector<TurningMark> marks_;  ///< not yet made, in order
  double along_m_ = 0;
};

}  // namespace aisle
