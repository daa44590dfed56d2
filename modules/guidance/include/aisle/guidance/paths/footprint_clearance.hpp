#pragma once

#include <limits>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/floor_clearance.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

inline constexpr double kClearanceNoise_m = 0.004;  ///< of the room that a vehicle seems to have

/// Beyond the margin around a footprint; negative: too little.
struct RelaxedClearance {
  double free_m = 0;      ///< of known free floor
  double standing_m = 0;  ///< up to what is known to stand there
};

/// Whether a vehicle's footprint, and a margin around it, lies on floor that is known to be free: the
/// footprint is covered by discs, which stick out over its sides by 5 mm and over its ends by 1.6 cm at most
/// where there is little room.
class FootprintClearance {
 public:
  FootprintClearance(const Footprint& footprint, double margin_m);

  bool fits(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle) const {
    return clearance_m(floor, clearance, T_map_vehicle, 0) >= 0;
  }
  /// How much room there is beyond the margin; negative: too little. Less than `enough_m` is not
  /// distinguished: there may be even less.
  double clearance_m(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                     double enough_m = -std::numeric_limits<double>::infinity()) const;

  /// The same towards what is known to stand there only.
  double standing_clearance_m(const FloorGrid& floor, const FloorClearance& clearance,
                              const Pose2& T_map_vehicle) const;
  RelaxedClearance relaxed_clearance(const FloorGrid& floor, const FloorClearance& clearance,
                                     const Pose2& T_map_vehicle) const {
    return {clearance_m(floor, clearance, T_map_vehicle),
            standing_clearance_m(floor, clearance, T_map_vehicle)};
  }
  /// Whether at least the whole footprint lies on known free floor, no nearer to what stands there or was not
  /// seen than it must or than `least`, but for noise: where a vehicle is set down, it has not seen what is
  /// beside it, and in a narrow place it may have come nearer to something than it would go.
  bool fits_barely(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                   const RelaxedClearance& least) const {
    return fits_barely(floor, clearance, T_map_vehicle, clearance_m(floor, clearance, T_map_vehicle), least);
  }
  /// Where `clearance_m` is known already, at least as far as `least` needs it.
  bool fits_barely(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                   double clearance_m, const RelaxedClearance& least) const;

  /// Whether the whole footprint lies on known free floor.
  bool lies_on_free(const FloorGrid& floor, const FloorClearance& clearance,
                    const Pose2& T_map_vehicle) const;

  /// How far along a path, from a point on it, the vehicle fits, if barely with so much room: up to its end,
  /// or less.
  double free_path_m(const FloorGrid& floor, const FloorClearance& clearance, const Path& path, double from_m,
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

  void cover(const Piece& piece, const Vec2& size_max_m, std::vector<Disc>& discs) const;
  template <class DistanceAt>
  double least_m(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                 double enough_m, DistanceAt distance_at) const;

  Footprint footprint_;
  double margin_m_;
  std::vector<Disc> rough_;  ///< few discs, which stick out far over its ends
  std::vector<Disc> close_;  ///< many, which stick out little
};

}  // namespace aisle
