#pragma once
/// From one drive by hand to a list of sections: L03 section 3.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "aisle/control/path_fit.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/sensed_segment.hpp"
#include "aisle/maps/section.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What one cycle of the drive recorded.
struct SectionCycle {
  double stamp_s = 0;
  OdometryReading odometry;
  std::vector<SensedSegment> floor_edges;  ///< in base_link
};

struct SectionLearningParams {
  double corner_rad =
      12 * kDegree;  ///< t_a: two left turns whose sum is within this of a quarter turn are a corner
  double crossing_rad = 12 * kDegree;  ///< t_b: a turn within this of a quarter turn counts as one
  double crossing_m = 0.3;             ///< t_c: by which a path across may differ from the corridor's width
  double corner_max_m = 1.5;           ///< two left turns farther apart are two corners
  double turn_min_rad = 20 * kDegree;  ///< smaller turns are wander
  double unseen_max_m = 5;             ///< after this far without a base line a vehicle loses its path
  PathFitParams path{.stray_max_m = 0.1, .radius_min_m = 0.2};

  void describe(FieldList& fields);
};

/// A segment of a drive on which no base line (wall-floor edge) was seen where it usually is.
struct UnseenPathSegment {
  double from_m = 0;  ///< along the path, from its start
  double length_m = 0;
};

/// A recorded drive, and what was seen beside it.
struct DrivenList {
  SectionList sections;                    ///< only kFollow, kBack and kTurn (L03 Table 2: a b l r)
  Pose2 T_route_start;                     ///< where the list begins, in `route`
  std::optional<double> corridor_width_m;  ///< median of left plus right distance
  UnseenPathSegment unseen;                ///< the longest one
  std::vector<Pose2> T_route_vehicle;      ///< at each cycle; the walls are the axes of `route`
};

/// L03 section 3.1, from any recorded drive. Odometry and the walls, which are straight and at right angles,
/// give the vehicle's poses, all cycles together. The path is smoothed to lines and arcs, and lines nearly
/// parallel to walls are made exactly parallel. A straight line becomes `a` (backwards: `b`) with the usual
/// distances of the base lines beside it, cut in two where one steps to the side for good. A turn on the spot
/// or to the right becomes one turn at the corner of the lines before and after it; a left turn on an arc
/// becomes two turns with the chord between. Turns are rounded to the quantum, and to a quarter turn where
/// they miss it by less than `crossing_rad`.
/// @return without sections if the vehicle did not go anywhere
DrivenList record_drive(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                        const SectionLearningParams& params);

/// Several drives of one path, merged.
struct MergedDrives {
  DrivenList driven;
  std::vector<std::size_t>
      taken;  ///< indices of the drives with the most common form; the others are left out
};

/// Merges drives. Drives went the same way if their lists have the same form: the same symbols, turns equal
/// within three quanta, lengths within half a metre or a tenth. Of the most common form (in a tie, the
/// earliest drive's) each length, turn and distance is the median. The poses are the earliest drive's, and
/// the longest segment without a base line is that of the drive that saw the most.
/// @param drives  at least one
MergedDrives merge_drives(std::span<const DrivenList> drives);

/// L03 Algorithm 1: finds corners, paths across, and paths before right turns; the rest is followed along a
/// base line.
SectionList decide_sections(const SectionList& driven, std::optional<double> corridor_width_m,
                            const SectionLearningParams& params);

}  // namespace aisle
