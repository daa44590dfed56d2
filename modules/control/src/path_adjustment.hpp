#pragma once

#include <cstddef>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

/// A path in the making: what its pieces are, how long and how bent, and where they start. Adjusting makes
/// them join. Headings are not wrapped: the end's heading is the start's plus the turn.
struct LoosePiece {
  enum class Kind { kLine, kArc, kTurnOnTheSpot };
  Kind kind = Kind::kArc;
  Gear gear = Gear::kForward;
  Pose2 T_map_start;
  double length_m = 0;  ///< > 0, but 0 of a turn on the spot
  double turn_rad = 0;  ///< left positive; 0 of a line
  double driven_m = 0;  ///< length as driven, approximately

  Arc arc() const;
  Pose2 end() const;
};

/// A point where base_link was, and the piece that must pass there.
struct DrivenPoint {
  Vec2 p_map;
  std::size_t piece = 0;
  double stray_share = 1;  ///< share of the allowed stray that applies here
  double weight = 1;
  bool begins_leg = false;
  bool ends_leg = false;
};

struct LoosePath {
  std::vector<LoosePiece> pieces;
  std::vector<DrivenPoint> driven_points;
  Pose2 T_map_end;
};

/// Moves, stretches and bends the pieces until they join and the weighted sum of squared distances of the
/// driven points from them is least.
void adjust(LoosePath& loose, double radius_min_m);

/// The joined pieces.
Path joined(const LoosePath& loose);

}  // namespace aisle
