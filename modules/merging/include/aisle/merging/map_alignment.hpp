#pragma once
/// How two maps of one building lie to each other, from no guess at all.

#include <string>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/merging/map_pattern.hpp"

namespace aisle {

struct MapAlignmentParams {
  double common_min_m = 12;     ///< walls that both maps must have
  double fixing_min_m = 3;      ///< of these, across every direction
  double agreement_min = 0.75;  ///< share of the walls in sight of both that both must have
  double denied_run_max_m = 1;  ///< a longer piece of wall that one map denies contradicts a placement
  bool allows_changes = true;   ///< a contradicted placement may be the true one: something was built
  double rival_share = 0.35;    ///< a placement with this share of the best one's score makes it ambiguous
  double contradicted_share = 0.75;  ///< the same of one that is contradicted
  double rival_agreement = 0.6;      ///< if the maps agree so far at it
  double apart_m = 0.5;              ///< placements nearer than this are one
  double apart_rad = 5 * kDegree;
  int guesses_max = 20000;  ///< with more, not all placements were looked at, and none is believed

  void describe(FieldList& fields);
};

/// One way to lay a map onto another.
struct MapPlacement {
  Pose2 T_fixed_moved;
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta), from the walls that both have
  MapOverlap overlap;

  double sigma_m() const;    ///< standard deviation of the position, in its worse direction
  double sigma_rad() const;  ///< of the turn
};

enum class AlignmentVerdict {
  kFound,      ///< one placement, and no other comes near it
  kAmbiguous,  ///< several placements explain the maps: parts of the building look alike
  kApart,      ///< no placement has enough walls in common: the maps hardly overlap, or are of two buildings
  kUnsearched  ///< there were too many placements to look at all of them
};

struct MapAlignment {
  AlignmentVerdict verdict = AlignmentVerdict::kApart;
  std::vector<MapPlacement> placements;  ///< the best first, then its rivals and what else comes near; few
  double rival_share = 0;                ///< of the best one's score, that the best other placement has

  bool is_found() const { return verdict == AlignmentVerdict::kFound; }
  /// Only if there are placements.
  const MapPlacement& best() const { return placements.front(); }
};

/// "Parts of the building look alike: ..."
std::string reason_of(const MapAlignment& alignment);

/// Looks at every placement at which the maps may have `common_min_m` of walls in common, and believes the
/// best one only if no other explains as much.
MapAlignment align_maps(const MapPattern& fixed, const MapPattern& moved, const MapAlignmentParams& params);

/// A placement settled from a guess: Gauss-Newton on the distance of the moved map's wall pieces from the
/// fixed map's faces, with a Cauchy weight. O(pieces)
MapPlacement settle_map(const MapPattern& fixed, const MapPattern& moved, const Pose2& T_fixed_guess);

}  // namespace aisle
