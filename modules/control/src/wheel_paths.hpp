#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/vehicle/front_steered.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

/// The paths of the front and the rear wheels' middles about one point of a path, within one leg, each
/// continued straight on before and after the leg.
class WheelPaths {
 public:
  /// @param reach_m  how much of the path before and after `from` is considered
  WheelPaths(const FrontSteered& vehicle, const Path& path, const PathPoint& from, double reach_m);

  /// In which the leg is driven.
  Gear gear() const { return gear_; }

  /// D_front + D_back of C98 eq. (15), with the vehicle's base_link at `T_map_vehicle`.
  double distance_sum(const Pose2& T_map_vehicle) const;

 private:
  void add(const PathPiece& rear);

  FrontSteered vehicle_;
  Gear gear_;
  std::vector<PathPiece> rear_, front_;
};

}  // namespace aisle
