#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Distance from a point to a vehicle's footprint [m]; 0 inside.
double distance_to(const Footprint& footprint, const Vec2& p_vehicle);

/// Whether a segment, given in base_link, touches or crosses the footprint.
bool intersects(const Footprint& footprint, const Segment2& in_vehicle);

/// What a vehicle may hit.
class Obstacles {
 public:
  Obstacles(const World& world, const Footprint& footprint);

  /// Replaces the outlines of what is not part of the world.
  void set_movers(std::vector<Segment2> movers) { movers_ = std::move(movers); }
  std::span<const Segment2> movers() const { return movers_; }

  bool touch(const Pose2& T_world_vehicle);

  /// Share of the arc that is free before the vehicle touches something, to a fraction of a millimetre; 1:
  /// all of it; 0 from a pose that touches.
  double free_share(const Pose2& T_world_vehicle, const Arc& path);

 private:
  void gather_near(const Vec2& p_world);

  Footprint footprint_;
  double reach_m_;
  std::vector<Segment2> fixed_;
  std::vector<Segment2> movers_;
  std::vector<Segment2> near_;  ///< those of `fixed_` that could be touched from around `gathered_at_`
  std::optional<Vec2> gathered_at_;
};

}  // namespace aisle
