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

/// What one cycle of the drive given.
struct SectionCycle {
  double stamp_s = 0;
  OdometryReading odometry;
  std::vector<SensedSegment> floor_edges;  ///< in base_link
};

struct SectionLearningParams {
  double corner_rad =
      12 * kDegree;  ///< t_a: two left turns that sum to a quarter turn so nearly are a corner
  double crossing_rad = 12 * kDegree;  ///< t_b: a turn that is so nearly a quarter turn
  double crossing_m = 0.3;             ///< t_c: by which a path across may miss the corridor's width
  double corner_max_m = 1.5;           ///< farther apart two left turns are two corners
  double turn_min_rad = 20 * kDegree;  ///< less is wander
  double unseen_max_m = 5;             ///< farther without a base line a vehicle loses its path
  PathFitParams path{.stray_max_m = 0.1, .radius_min_m = 0.2};

  void describe(FieldList& fields);
};

/// A segment of a drive on which no base line was seen where it usually is.
struct UnseenPathSegment {
  double from_m = 0;  ///< along the path, from its start
  double length_m = 0;
};

/// A drive as it was recorded, and what was seen beside it.
struct DrivenList {
  SectionList sections;                    ///< kFollow, kBack and kTurn alone (L03 Table 2: a b l r)
  Pose2 T_route_start;                     ///< where the list begins
  std::optional<double> corridor_width_m;  ///< median of left and right distances together
  UnseenPathSegment unseen;                ///< the longest
  std::vector<Pose2> T_route_vehicle;      ///< of each cycle; the walls are the axes of `route`
};

/// L03 section 3.1, from any recorded drive. Where the vehicle is follows from its odometry and from the
/// walls, which are straight and at right angles, all cycles together; the path is smoothed to lines and
/// arcs, and lines that run nearly along walls are laid exactly so. A straight line becomes `a` (backwards:
/// `b`) with the usual distances of the base lines beside it, cut in two where one steps to the side for
/// good; a turn on the spot or to the right becomes one turn at the corner of the lines before and after it;
/// a left turn on an arc becomes two turns with the chord between. Turns are rounded to the quantum, and to a
/// quarter turn where they miss it by less than `crossing_rad`.
/// @return without sections if the vehicle did not go anywhere
DrivenList record_drive(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                        const SectionLearningParams& params);

/// Several drives of one path as one.
struct MergedDrives {
  DrivenList driven;
  std::vector<std::size_t> taken;  ///< drives of the form that most have; the others are left out
};

/// Drives whose lists have the same form went the same way: the same symbols, turns alike to three quanta,
/// lines as long to half a metre or a tenth. Of the form that most have (of as many: the earliest drive's)
/// each length, turn and distance is the middle one; where each cycle was is the earliest one's, and the
/// longest segment without a base line that of the drive that saw the most.
/// @param drives  at least one
MergedDrives merge_drives(std::span<const DrivenList> drives);

/// L03 Algorithm 1: corners, paths across, paths before right turns; what is left is followed along a base
/// line.
SectionList decide_sections(const SectionList& driven, std::optional<double> corridor_width_m,
                            const SectionLearningParams& params);

}  // namespace aisle
