#pragma once
/// Areas of the floor drawn by a person, in which a vehicle drives otherwise than elsewhere.

#include <span>
#include <string>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/maps/barrier.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

struct Zone {
  enum class Kind {
    kKeepOut,  ///< no part of a vehicle enters it
    kSlow,     ///< driven at `speed_max_mps` at most
    kOneWay    ///< driven in `direction_rad` only
  };

  Kind kind = Kind::kKeepOut;
  std::string name;            ///< may be empty
  std::vector<Vec2> outline;   ///< in `map`, at least three corners; the last is joined to the first
  double speed_max_mps = 0.2;  ///< of a slow zone
  double direction_rad = 0;    ///< of a one-way zone: a heading in `map`
};

/// "slow zone 'lift'", "one-way zone"
std::string words_for(const Zone& zone);

/// Whether a point lies inside.
bool contains(const Zone& zone, const Vec2& p_map);

/// The keep-out zone around a point; nullptr: none.
const Zone* keep_out_around(std::span<const Zone> zones, const Vec2& p_map);

/// Whether some part of a vehicle's outline lies inside.
bool overlaps(const Zone& zone, const Footprint& footprint, const Pose2& T_map_vehicle);

/// The greatest speed that the zones allow a vehicle at this pose; infinite: they do not limit it.
double speed_max_mps(std::span<const Zone> zones, const Footprint& footprint, const Pose2& T_map_vehicle);

/// Crossing a one-way zone is not driving against it: as far as this a path may lead off its direction.
inline constexpr double kOffOneWayMax_rad = 100 * kDegree;

/// The one-way zone around a vehicle's reference point that it drives against in this gear, more than
/// `off_max_rad` away from the zone's own direction; nullptr: none.
const Zone* one_way_against(std::span<const Zone> zones, const Pose2& T_map_vehicle, Gear gear,
                            double off_max_rad = kOffOneWayMax_rad);

/// The edges of all keep-out zones, as barriers.
std::vector<Barrier> outlines(std::span<const Zone> zones);

}  // namespace aisle
