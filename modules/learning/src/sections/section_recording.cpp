#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"
#include "aisle/learning/pose_filter.hpp"
#include "aisle/learning/sections/section_learning.hpp"
#include "aisle/learning/sections/walls_beside.hpp"
#include "aisle/learning/walls/wall_heading.hpp"
#include "sections/base_line_steps.hpp"
#include "sections/path_settling.hpp"

namespace aisle {

void SectionLearningParams::describe(FieldList& fields) {
  fields.angle("corner_deg", corner_rad, {0.1, 45},
               "t_a: two left turns whose sum is within this of a quarter turn are a corner");
  fields.angle("crossing_deg", crossing_rad, {0.1, 45},
               "t_b: a turn within this of a quarter turn counts as one");
  fields.real("crossing_m", crossing_m, {0.01, 2},
              "t_c: by which a path across may differ from the corridor's width");
  fields.real("corner_max_m", corner_max_m, {0.1, 10}, "two left turns farther apart are two corners");
  fields.angle("turn_min_deg", turn_min_rad, {1, 45}, "smaller turns are wander");
  fields.real("unseen_max_m", unseen_max_m, {0.5, 1000},
              "a drive that saw no base line for a longer distance is not used for learning");
  fields.group("path", path);
}

namespace {

constexpr double kStartSigma_rad = 5 * kDegree;  // heading against the wall beside which a drive begins
constexpr double kKnownEdge_rad = 3 * kDegree;   // sigma of an edge's direction, at most
constexpr double kParallel_rad = 6 * kDegree;    // segments within this of parallel were meant to be
constexpr double kOnAxis_rad = 1e-6;             // rounding of what was made parallel
constexpr double kPathPoints_m = 0.05;
constexpr double kTurnsOnTheSpot_rad = 8 * kDegree;  // more than a heading correction while it stands
constexpr double kTurnRadiusMax_m = 2.5;             // gentler bends are odometry drift, or wander
constexpr double kStraightMin_m = 0.1;               // shorter lines between turns belong to them
constexpr double kRoundMin_rad = 2.3;  // a larger turn is a U-turn: two turns with a path between
constexpr double kMeetingMin = 0.2;    // sine of the angle at which lines still meet
constexpr double kOnSegment_m = 0.3,
                 kOnSegment_rad = 20 * kDegree;  // a vehicle within this drives along the line
constexpr double kBesideMin_m = 0.12, kBesideMax_m = 3;
constexpr double kSameLine_m = 0.25;  // a base line farther from its usual position is another one
constexpr std::size_t kSeenMin = 5;   // cycles that must show a base line for its distance to count

/// Headings by odometry and the walls, which are the axes of `route`: right to some degrees. An edge whose
/// direction is hardly visible is often floor texture, and texture seen again and again misleads.
std::vector<double> followed_headings(std::span<const SectionCycle> cycles,
                                      const VehicleDescription& vehicle) {
  PoseFilter filter(vehicle, about({}, 0, kStartSigma_rad));
  std::vector<double> headings_rad;
  headings_rad.reserve(cycles.size());
  std::vector<SensedSegment> known;
  for (const SectionCycle& cycle : cycles) {
    filter.predict(cycle.odometry);
    const double theta = filter.pose().theta;
    known.clear();
    std::copy_if(cycle.floor_edges.begin(), cycle.floor_edges.end(), std::back_inserter(known),
                 [](const SensedSegment& edge) { return edge.sigma_heading_rad <= kKnownEdge_rad; });
    const auto walls = heading_from_walls(known, theta, std::sqrt(filter.covariance()(2, 2)));
    if (walls) filter.correct(wrap_angle(walls->heading_rad - theta), Vec3::UnitZ(), walls->sigma_rad);
    headings_rad.push_back(filter.pose().theta);
  }
  return headings_rad;
}

std::vector<Pose2> waypoints(const std::vector<Pose2>& poses) {
  std::vector<Pose2> points;
  for (const Pose2& T : poses) {
    if (points.empty() || (T.position() - points.back().position()).norm() >= kPathPoints_m ||
        std::abs(wrap_angle(T.theta - points.back().theta)) > kTurnsOnTheSpot_rad)
      points.push_back(T);
  }
  return points;
}

/// A straight segment of the path.
struct StraightSegment {
  Pose2 T_route_start;
  double length_m = 0;                      ///< negative: backwards
  double along_from_m = 0, along_to_m = 0;  ///< along the whole path

  Vec2 end() const { return T_route_start * Vec2(length_m, 0); }
};

/// The path's straight segments. Parts that bend less than a turn are one segment, laid from their first to
/// their last point.
std::vector<StraightSegment> straight_segments(const Path& path, double turn_min_rad) {
  std::vector<StraightSegment> segments;
  bool is_open = false;
  for (std::size_t i = 0; i < path.pieces().size(); ++i) {
    const PathPiece& piece = path.pieces()[i];
    const bool is_turning =
        piece.is_on_the_spot() || (std::abs(piece.arc.turn_rad) >= turn_min_rad &&
                                   std::abs(piece.curvature_per_m()) > 1 / kTurnRadiusMax_m);
    if (is_turning) {
      is_open = false;
      continue;
    }
    const bool goes_on = is_open && (segments.back().length_m > 0) == (piece.arc.length_m > 0);
    if (!goes_on) segments.push_back({.T_route_start = piece.T_map_start, .along_from_m = path.start_m(i)});
    StraightSegment& segment = segments.back();
    const Vec2 chord = piece.end().position() - segment.T_route_start.position();
    const double sign = piece.arc.length_m < 0 ? -1 : 1;
    segment.T_route_start.theta = heading_of(sign * chord);
    segment.length_m = sign * chord.norm();
    segment.along_to_m = path.start_m(i) + piece.path_m();
    is_open = true;
  }
  std::erase_if(segments,
                [](const StraightSegment& segment) { return std::abs(segment.length_m) < kStraightMin_m; });
  return segments;
}

/// Makes a segment that is nearly parallel to an axis exactly parallel, about its middle: a human driver
/// wanders, walls do not.
void lay_parallel(StraightSegment& segment) {
  const double off_rad = wrap_quarter_turn(segment.T_route_start.theta);
  if (std::abs(off_rad) > kParallel_rad) return;
  const Pose2 T_route_middle = segment.T_route_start * Pose2{segment.length_m / 2, 0, -off_rad};
  segment.T_route_start = T_route_middle * Pose2{-segment.length_m / 2, 0, 0};
}

bool goes_anywhere(const std::vector<Pose2>& T_route_vehicle) {
  return std::any_of(T_route_vehicle.begin(), T_route_vehicle.end(), [&](const Pose2& T) {
    return (T.position() - T_route_vehicle.front().position()).norm() > kStraightMin_m;
  });
}

std::vector<StraightSegment> segments_of(const std::vector<Pose2>& T_route_vehicle,
                                         const SectionLearningParams& params) {
  std::vector<StraightSegment> segments =
      straight_segments(fit_path(waypoints(T_route_vehicle), params.path), params.turn_min_rad);
  for (StraightSegment& segment : segments) lay_parallel(segment);
  return segments;
}

bool is_on(const StraightSegment& segment, const Pose2& T_segment_vehicle) {
  return T_segment_vehicle.x >= 0 && T_segment_vehicle.x <= segment.length_m &&
         std::abs(T_segment_vehicle.y) < kOnSegment_m && std::abs(T_segment_vehicle.theta) < kOnSegment_rad;
}

/// The parts of a segment along which the base lines keep their distances.
std::vector<StraightSegment> parts_of(const StraightSegment& segment, std::span<const SectionCycle> cycles,
                                      const std::vector<Pose2>& T_route_vehicle) {
  if (segment.length_m < 0) return {segment};
  std::vector<PathSegmentView> views;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Pose2 T_segment_vehicle = between(segment.T_route_start, T_route_vehicle[i]);
    if (is_on(segment, T_segment_vehicle)) views.push_back({T_segment_vehicle, cycles[i].floor_edges});
  }
  std::vector<StraightSegment> parts;
  const auto add = [&](double from_m, double to_m) {
    parts.push_back(
        {.T_route_start = segment.T_route_start * Pose2{from_m, 0, 0}, .length_m = to_m - from_m});
  };
  double from_m = 0;
  for (const double step_m : base_line_steps_m(segment.length_m, views))
    add(std::exchange(from_m, step_m), step_m);
  add(from_m, segment.length_m);
  return parts;
}

/// The segments along the axes, each with the cycles from first to last on it.
std::vector<DrivenPathSegment> path_segments_of(const std::vector<StraightSegment>& segments,
                                                const std::vector<Pose2>& T_route_vehicle) {
  std::vector<DrivenPathSegment> path_segments;
  std::size_t i = 0;
  for (const StraightSegment& segment : segments) {
    if (segment.length_m < 0 || std::abs(wrap_quarter_turn(segment.T_route_start.theta)) > kOnAxis_rad)
      continue;
    const auto is_on_segment = [&](std::size_t at) {
      return is_on(segment, between(segment.T_route_start, T_route_vehicle[at]));
    };
    std::size_t first = i;
    while (first < T_route_vehicle.size() && !is_on_segment(first)) ++first;
    if (first == T_route_vehicle.size()) continue;
    for (i = first; i < T_route_vehicle.size() && is_on_segment(i); ++i) {
    }
    path_segments.push_back({first, i, segment.T_route_start.theta});
  }
  return path_segments;
}

/// The driven path, estimated first from the observed directions, then also from the walls beside its
/// straight segments.
std::vector<Pose2> path_of(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                           const SectionLearningParams& params) {
  std::vector<Pose2> T_route_vehicle = settled_path(cycles, vehicle, followed_headings(cycles, vehicle), {});
  if (!goes_anywhere(T_route_vehicle)) return T_route_vehicle;
  std::vector<StraightSegment> parts;
  for (const StraightSegment& segment : segments_of(T_route_vehicle, params)) {
    const std::vector<StraightSegment> of_segment = parts_of(segment, cycles, T_route_vehicle);
    parts.insert(parts.end(), of_segment.begin(), of_segment.end());
  }
  const auto path_segments = path_segments_of(parts, T_route_vehicle);
  std::vector<double> headings_rad;
  headings_rad.reserve(T_route_vehicle.size());
  for (const Pose2& T : T_route_vehicle) headings_rad.push_back(T.theta);
  return settled_path(cycles, vehicle, std::move(headings_rad), path_segments);
}

double rounded_turn_rad(double turn_rad, double quarter_rad) {
  const double quarters = std::round(turn_rad / (kPi / 2)) * (kPi / 2);
  if (quarters != 0 && std::abs(turn_rad - quarters) < quarter_rad) return quarters;
  return std::round(turn_rad / kTurnQuantum_rad) * kTurnQuantum_rad;
}

Section straight(double length_m) {
  return {.kind = length_m < 0 ? Section::Kind::kBack : Section::Kind::kFollow,
          .length_m = std::abs(length_m)};
}

void append_turn(SectionList& list, double turn_rad) {
  if (turn_rad != 0) list.push_back({.kind = Section::Kind::kTurn, .turn_rad = turn_rad});
}

/// Extends two segments to the corner where their lines meet.
void lead_to_corner(StraightSegment& before, StraightSegment& after, const Vec2& gap, double turn_rad) {
  if (std::abs(std::sin(turn_rad)) < kMeetingMin) {
    before.length_m += gap.x();
    return;
  }
  const double back_m = gap.y() / std::sin(turn_rad);
  before.length_m += gap.x() - back_m * std::cos(turn_rad);
  after.T_route_start = after.T_route_start * Pose2{-back_m, 0, 0};
  after.length_m += back_m;
}

/// The connection of two segments: one turn at their corner, or two with a path between.
SectionList joint(StraightSegment& before, StraightSegment& after, const SectionLearningParams& params) {
  const double turn_rad = wrap_angle(after.T_route_start.theta - before.T_route_start.theta);
  const Vec2 gap = rotate(-before.T_route_start.theta, after.T_route_start.position() - before.end());
  const auto round_turn = [&](double angle_rad) { return rounded_turn_rad(angle_rad, params.crossing_rad); };
  SectionList list;
  const bool goes_round = std::abs(turn_rad) > kRoundMin_rad;
  if (gap.norm() < kStraightMin_m || (turn_rad <= 0 && !goes_round)) {
    lead_to_corner(before, after, gap, turn_rad);
    append_turn(list, round_turn(turn_rad));
    return list;
  }
  const double gap_rad = heading_of(gap);
  append_turn(list, round_turn(gap_rad));
  list.push_back(straight(gap.norm()));
  append_turn(list, round_turn(wrap_angle(turn_rad - gap_rad)));
  return list;
}

/// Distances of the base lines beside a segment, one for each cycle that shows them.
struct DistancesBeside {
  struct Distance {
    std::size_t cycle = 0;
    double distance_m = 0;
  };
  std::vector<Distance> right, left;
  std::vector<double> ahead_m;
};

/// Distance from a segment's end to the nearest wall across it; nullopt: none was seen from near.
std::optional<double> distance_ahead(const StraightSegment& segment, const Pose2& T_segment_vehicle,
                                     const std::vector<WallAcross>& across) {
  std::optional<double> nearest_m;
  for (const WallAcross& wall : across) {
    const double ahead_m = wall.along_m - segment.length_m;
    const bool is_ahead = ahead_m > kBesideMin_m && wall.along_m - T_segment_vehicle.x < kAcrossNear_m;
    if (!is_ahead || wall.from_m > kPathWidth_m || wall.to_m < -kPathWidth_m) continue;
    if (!nearest_m || ahead_m < *nearest_m) nearest_m = ahead_m;
  }
  return nearest_m;
}

DistancesBeside distances_beside(const StraightSegment& segment, std::span<const SectionCycle> cycles,
                                 const std::vector<Pose2>& T_route_vehicle) {
  DistancesBeside distances;
  std::vector<WallBeside> beside;
  std::vector<WallAcross> across;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Pose2 T_segment_vehicle = between(segment.T_route_start, T_route_vehicle[i]);
    if (!is_on(segment, T_segment_vehicle)) continue;
    find_walls_across(cycles[i].floor_edges, T_segment_vehicle, across);
    if (const auto ahead_m = distance_ahead(segment, T_segment_vehicle, across))
      distances.ahead_m.push_back(*ahead_m);
    find_walls_beside(cycles[i].floor_edges, T_segment_vehicle, beside);
    double right_m = kBesideMax_m, left_m = kBesideMax_m;
    for (const WallBeside& wall : beside) {
      if (wall.from_m > segment.length_m || std::abs(wall.lateral_m) < kBesideMin_m) continue;
      double& nearest_m = wall.lateral_m < 0 ? right_m : left_m;
      nearest_m = std::min(nearest_m, std::abs(wall.lateral_m));
    }
    if (right_m < kBesideMax_m) distances.right.push_back({i, right_m});
    if (left_m < kBesideMax_m) distances.left.push_back({i, left_m});
  }
  return distances;
}

std::optional<double> usual(std::vector<double> distances_m) {
  if (distances_m.size() < kSeenMin) return std::nullopt;
  return median(std::move(distances_m));
}

/// The median distance of a base line; marks the cycles that saw it there.
std::optional<double> usual(const std::vector<DistancesBeside::Distance>& seen, std::vector<bool>& is_seen) {
  std::vector<double> distances_m;
  distances_m.reserve(seen.size());
  for (const auto& one : seen) distances_m.push_back(one.distance_m);
  const auto usual_m = usual(std::move(distances_m));
  if (!usual_m) return std::nullopt;
  for (const auto& one : seen)
    if (std::abs(one.distance_m - *usual_m) < kSameLine_m) is_seen[one.cycle] = true;
  return usual_m;
}

/// The longest part of the path on which no base line was seen.
UnseenPathSegment longest_unseen(const std::vector<bool>& is_seen,
                                 const std::vector<Pose2>& T_route_vehicle) {
  UnseenPathSegment longest;
  double along_m = 0, seen_at_m = 0;
  for (std::size_t i = 0; i < is_seen.size(); ++i) {
    if (i > 0) along_m += (T_route_vehicle[i].position() - T_route_vehicle[i - 1].position()).norm();
    if (is_seen[i]) seen_at_m = along_m;
    if (along_m - seen_at_m > longest.length_m) longest = {seen_at_m, along_m - seen_at_m};
  }
  return longest;
}

/// Appends straight sections along the base lines, at the observed distances.
/// @param is_seen  set to true for the cycles that show a base line
void append_follow(SectionList& list, const StraightSegment& segment, std::span<const SectionCycle> cycles,
                   const std::vector<Pose2>& T_route_vehicle, std::vector<bool>& is_seen) {
  const std::vector<StraightSegment> parts = parts_of(segment, cycles, T_route_vehicle);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const DistancesBeside distances = distances_beside(parts[i], cycles, T_route_vehicle);
    Section section = straight(parts[i].length_m);
    section.right_m = usual(distances.right, is_seen);
    section.left_m = usual(distances.left, is_seen);
    if (i + 1 == parts.size()) section.ahead_m = usual(distances.ahead_m);
    list.push_back(section);
  }
}

/// Where the first segment begins: on its line, unless the vehicle was farther off than a human driver
/// wanders. Then odometry has bent the path, and it begins at the vehicle's position.
Pose2 beginning(const StraightSegment& first, const Pose2& T_route_vehicle) {
  const double lateral_m = between(first.T_route_start, T_route_vehicle).y;
  return std::abs(lateral_m) < kOnSegment_m ? first.T_route_start
                                            : first.T_route_start * Pose2{0, lateral_m, 0};
}

}  // namespace

DrivenList record_drive(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                        const SectionLearningParams& params) {
  DrivenList driven{
      .sections = {}, .corridor_width_m = {}, .T_route_vehicle = path_of(cycles, vehicle, params)};
  if (!goes_anywhere(driven.T_route_vehicle)) return driven;
  std::vector<StraightSegment> segments = segments_of(driven.T_route_vehicle, params);
  std::vector<SectionList> joints;
  for (std::size_t i = 1; i < segments.size(); ++i)
    joints.push_back(joint(segments[i - 1], segments[i], params));
  if (segments.empty()) return driven;
  std::vector<bool> is_seen(cycles.size(), false);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i > 0) driven.sections.insert(driven.sections.end(), joints[i - 1].begin(), joints[i - 1].end());
    if (segments[i].length_m > 0) {
      append_follow(driven.sections, segments[i], cycles, driven.T_route_vehicle, is_seen);
    } else {
      driven.sections.push_back(straight(segments[i].length_m));
    }
  }
  driven.unseen = longest_unseen(is_seen, driven.T_route_vehicle);
  std::vector<double> widths_m;
  for (const Section& section : driven.sections)
    if (section.right_m && section.left_m) widths_m.push_back(*section.right_m + *section.left_m);
  driven.T_route_start = beginning(segments.front(), driven.T_route_vehicle.front());
  if (!widths_m.empty()) driven.corridor_width_m = median(std::move(widths_m));
  return driven;
}

}  // namespace aisle
