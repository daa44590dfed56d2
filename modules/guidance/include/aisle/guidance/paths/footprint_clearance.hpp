#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/known_floor.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

inline constexpr double kClearanceNoise_m = 0.004;  ///< of a measured clearance

/// Clearance beyond the margin around a footprint; negative: too little.
struct RelaxedClearance {
  double free_m = 0;      ///< to floor that is occupied or unknown
  double standing_m = 0;  ///< to occupied floor only
};

/// Checks whether a vehicle's footprint, and a margin around it, lies on known free floor. Discs cover the
/// footprint; where there is little clearance they extend over its sides by at most 5 mm and over its ends by
/// at most 1.6 cm.
class FootprintClearance {
 public:
  FootprintClearance(const Footprint& footprint, double margin_m);

  bool fits(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
    return clearance_m(floor, T_map_vehicle, 0) >= 0;
  }
  /// Clearance beyond the margin; negative: too little. A result below `enough_m` is only an upper bound.
  double clearance_m(const KnownFloor& floor, const Pose2& T_map_vehicle,
                     double enough_m = -std::numeric_limits<double>::infinity()) const;

  /// The same, to occupied floor only.
  double standing_clearance_m(const KnownFloor& floor, const Pose2& T_map_vehicle) const;
  RelaxedClearance relaxed_clearance(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
    return {clearance_m(floor, T_map_vehicle), standing_clearance_m(floor, T_map_vehicle)};
  }
  /// Whether at least the whole footprint lies on known free floor, with its margin or else no less clearance
  /// than `least`, but for noise. At its start a vehicle has not seen the floor beside it, and in a narrow
  /// place it may have come nearer to something than it would plan to.
  bool fits_barely(const KnownFloor& floor, const Pose2& T_map_vehicle, const RelaxedClearance& least) const {
    return fits_barely(floor, T_map_vehicle, clearance_m(floor, T_map_vehicle), least);
  }
  /// The same when `clearance_m` is known already, at least as exactly as `least` needs it.
  bool fits_barely(const KnownFloor& floor, const Pose2& T_map_vehicle, double clearance_m,
                   const RelaxedClearance& least) const;

  /// Whether the whole footprint lies on known free floor.
  bool lies_on_free(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
    return lies_on(floor, T_map_vehicle, [&](FloorCell cell) { return floor.is_free(cell); });
  }
  /// Whether no part of it lies on occupied floor.
  bool lies_off_occupied(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
    return lies_on(floor, T_map_vehicle,
                   [&](FloorCell cell) { return floor.grid().at(cell) != Floor::kOccupied; });
  }
  /// Whether each part of it lies on floor that is free or was never seen.
  bool lies_on_free_or_unknown(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
    return lies_on(floor, T_map_vehicle, [&](FloorCell cell) {
      return floor.grid().at(cell) == Floor::kUnknown || floor.is_free(cell);
    });
  }

  /// How far the vehicle fits along a path from `from_m` on, where need be barely, with clearance `least`; at
  /// most to the path's end.
  double free_path_m(const KnownFloor& floor, const Path& path, double from_m,
                     const RelaxedClearance& least) const;

 private:
  struct Disc {
    Vec2 p_vehicle;
    double radius_m;  ///< with the margin
  };
  struct Piece {  ///< of the footprint
    Vec2 low;
    Vec2 high;
  };

  bool lies_on(const KnownFloor& floor, const Pose2& T_map_vehicle,
               const std::function<bool(FloorCell)>& is_good) const;
  void cover(const Piece& piece, const Vec2& size_max_m, std::vector<Disc>& discs) const;
  template <class DistanceAt>
  double least_m(const KnownFloor& floor, const Pose2& T_map_vehicle, double enough_m,
                 DistanceAt distance_at) const;

  Footprint footprint_;
  double margin_m_;
  std::vector<Disc> rough_;  ///< few discs, which extend far over its ends
  std::vector<Disc> close_;  ///< many, which extend little
};

}  // namespace aisle
