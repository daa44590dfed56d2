#pragma once

#include <span>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// The direction of a wall, with its free side on the left. The two sides of one wall run in opposite
/// directions, so they are never taken for each other.
enum class Facing { kEast, kNorth, kWest, kSouth, kOblique };

/// The facing of a wall with this heading; oblique if it is farther than `tolerance_rad` from every axis.
Facing facing_of(double heading_rad, double tolerance_rad);

/// Heading of an axis facing [rad]. Not for kOblique.
double heading_of(Facing facing);

/// A wall while it is being learned: a line with weights that grow with each sighting, and the interval along
/// it that was seen.
struct WallEstimate {
  Facing facing = Facing::kOblique;
  double heading_rad = 0;
  Vec2 along = Vec2::UnitX();   ///< unit vector of the heading
  Vec2 normal = Vec2::UnitY();  ///< to the left of `along`, towards the free side
  Vec2 anchor = Vec2::Zero();   ///< a point on the line, where its position is best known
  double offset_weight = 0;     ///< 1 / variance of the position along `normal` [1/m^2]
  double heading_weight = 0;    ///< 1 / variance of the heading [1/rad^2]
  Interval extent;              ///< along the line, from the anchor [m]
  WallEnd start = WallEnd::kUnknown;
  WallEnd end = WallEnd::kUnknown;
  int sightings = 0;
  double last_seen_m = 0;  ///< the vehicle's path length at the last sighting

  bool is_oblique() const { return facing == Facing::kOblique; }
  double length_m() const { return extent.length(); }
  Segment2 segment() const { return {anchor + along * extent.min, anchor + along * extent.max}; }
  Vec2 middle() const { return anchor + along * ((extent.min + extent.max) / 2); }
  double offset_of(const Vec2& p) const { return normal.dot(p - anchor); }
  Interval span_of(const Segment2& s) const;
  void set_heading(double heading_rad);
};

/// A sensed segment placed in the map from a known pose.
struct PlacedSegment {
  const SensedSegment* sensed = nullptr;
  Segment2 segment;
  Vec2 centroid = Vec2::Zero();
  double heading_rad = 0;

  PlacedSegment(const SensedSegment& sensed, const Pose2& T_map_sensor);
};

struct WallUpdateParams {
  double axis_tolerance_rad = 4 * kDegree;  ///< walls within this of an axis are orthogonal
  double gate_m = 0.12;                     ///< a segment farther away across the wall belongs to another one
  double gap_m = 0.15;                      ///< a segment farther away along the wall belongs to another one
  double weight_cap = 40;  ///< a wall's weight is capped at this many good sightings: old errors fade
};

/// How far a segment may be from a wall and still be matched with it.
struct AssociationGate {
  double offset_m = 0.25;
  double heading_rad = 0.1;
  double overlap_min_m = 0.1;  ///< negative: a gap along the wall is allowed
};

/// Index of the wall that the segment belongs to, or -1 if none. O(candidates).
int associate(const PlacedSegment& placed, std::span<const WallEstimate> walls,
              std::span<const int> candidates, const AssociationGate& gate);

/// Merges a segment into the wall that it belongs to, or adds a new wall. Returns the wall's index; a new
/// wall is appended to `walls` and to `candidates`.
int absorb(const PlacedSegment& placed, double path_m, const WallUpdateParams& params,
           std::vector<WallEstimate>& walls, std::vector<int>& candidates);

}  // namespace aisle
