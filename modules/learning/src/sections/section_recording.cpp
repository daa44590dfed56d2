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
               "t_a: two left turns that sum to a quarter turn so nearly are a corner");
  fields.angle("crossing_deg", crossing_rad, {0.1, 45}, "t_b: a turn that is so nearly a quarter turn");
  fields.real("crossing_m", crossing_m, {0.01, 2},
              "t_c: by which a path across may miss the corridor's width");
  fields.real("corner_max_m", corner_max_m, {0.1, 10}, "farther apart two left turns are two corners");
  fields.angle("turn_min_deg", turn_min_rad, {1, 45}, "less is wander");
  fields.real("unseen_max_m", unseen_max_m, {0.5, 1000},
              "a drive that saw no base line for farther is not learned from");
  fields.group("path", path);
}

namespace {

constexpr double kStartSigma_rad = 5 * kDegree;  // against the wall beside which a drive begins
constexpr double kKnownEdge_rad = 3 * kDegree;   // of an edge's direction
constexpr double kParallel_rad = 6 * kDegree;    // a segment that is nearly so was meant to be
constexpr double kOnAxis_rad = 1e-6;             // of what was laid there
constexpr double kPathPoints_m = 0.05;
constexpr double kTurnsOnTheSpot_rad = 8 * kDegree;  // more than a correction of the heading while it stands
constexpr double kTurnRadiusMax_m = 2.5;             // what bends less is drift of the odometry, or wander
constexpr double kStraightMin_m = 0.1;               // shorter lines between turns belong to them
constexpr double kRoundMin_rad = 2.3;  // a greater turn to either side goes round: two turns, a path between
constexpr double kMeetingMin = 0.2;    // sine of the angle at which lines still meet somewhere
constexpr double kOnRun_m = 0.3, kOnRun_rad = 20 * kDegree;  // so near a line a vehicle drives along it
constexpr double kBesideMin_m = 0.12, kBesideMax_m = 3;
constexpr double kSameLine_m = 0.25;  // a base line that is farther from where it usually is is another
constexpr std::size_t kSeenMin = 5;   // cycles in which a base line must be seen for its distance to count

/// Odometry, held by the walls, which are the axes of `route`: some degrees right. An edge whose direction is
/// hardly seen is as often a floor's grain, and grain that is seen again and again leads astray.
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

/// A straight path segment.
struct Run {
  Pose2 T_route_start;
  double length_m = 0;                      ///< backwards: negative
  double along_from_m = 0, along_to_m = 0;  ///< of the whole path

  Vec2 end() const { return T_route_start * Vec2(length_m, 0); }
};

/// The path's straight segments; what bends less than a turn is one segment, laid from its first to its last
/// point.
std::vector<Run> straight_runs(const Path& path, double turn_min_rad) {
  std::vector<Run> runs;
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
    const bool goes_on = is_open && (runs.back().length_m > 0) == (piece.arc.length_m > 0);
    if (!goes_on) runs.push_back({.T_route_start = piece.T_map_start, .along_from_m = path.start_m(i)});
    Run& run = runs.back();
    const Vec2 chord = piece.end().position() - run.T_route_start.position();
    const double sign = piece.arc.length_m < 0 ? -1 : 1;
    run.T_route_start.theta = heading_of(sign * chord);
    run.length_m = sign * chord.norm();
    run.along_to_m = path.start_m(i) + piece.path_m();
    is_open = true;
  }
  std::erase_if(runs, [](const Run& run) { return std::abs(run.length_m) < kStraightMin_m; });
  return runs;
}

/// Lays a segment that runs nearly along the axes exactly so, through its middle: a hand wanders, walls do
/// not.
void lay_parallel(Run& run) {
  const double off_rad = wrap_quarter_turn(run.T_route_start.theta);
  if (std::abs(off_rad) > kParallel_rad) return;
  const Pose2 T_route_middle = run.T_route_start * Pose2{run.length_m / 2, 0, -off_rad};
  run.T_route_start = T_route_middle * Pose2{-run.length_m / 2, 0, 0};
}

bool goes_anywhere(const std::vector<Pose2>& T_route_vehicle) {
  return std::any_of(T_route_vehicle.begin(), T_route_vehicle.end(), [&](const Pose2& T) {
    return (T.position() - T_route_vehicle.front().position()).norm() > kStraightMin_m;
  });
}

std::vector<Run> runs_of(const std::vector<Pose2>& T_route_vehicle, const SectionLearningParams& params) {
  std::vector<Run> runs =
      straight_runs(fit_path(waypoints(T_route_vehicle), params.path), params.turn_min_rad);
  for (Run& run : runs) lay_parallel(run);
  return runs;
}

bool is_on(const Run& run, const Pose2& T_run_vehicle) {
  return T_run_vehicle.x >= 0 && T_run_vehicle.x <= run.length_m && std::abs(T_run_vehicle.y) < kOnRun_m &&
         std::abs(T_run_vehicle.theta) < kOnRun_rad;
}

/// The parts of a segment, beside each of which the base lines keep their distances.
std::vector<Run> parts_of(const Run& run, std::span<const SectionCycle> cycles,
                          const std::vector<Pose2>& T_route_vehicle) {
  if (run.length_m < 0) return {run};
  std::vector<PathSegmentView> views;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Pose2 T_run_vehicle = between(run.T_route_start, T_route_vehicle[i]);
    if (is_on(run, T_run_vehicle)) views.push_back({T_run_vehicle, cycles[i].floor_edges});
  }
  std::vector<Run> parts;
  const auto add = [&](double from_m, double to_m) {
    parts.push_back({.T_route_start = run.T_route_start * Pose2{from_m, 0, 0}, .length_m = to_m - from_m});
  };
  double from_m = 0;
  for (const double step_m : base_line_steps_m(run.length_m, views))
    add(std::exchange(from_m, step_m), step_m);
  add(from_m, run.length_m);
  return parts;
}

/// Those of the runs that lie along the axes, and the cycles from first to last that are on each.
std::vector<DrivenPathSegment> path_segments_of(const std::vector<Run>& runs,
                                                const std::vector<Pose2>& T_route_vehicle) {
  std::vector<DrivenPathSegment> path_segments;
  std::size_t i = 0;
  for (const Run& run : runs) {
    if (run.length_m < 0 || std::abs(wrap_quarter_turn(run.T_route_start.theta)) > kOnAxis_rad) continue;
    const auto is_on_run = [&](std::size_t at) {
      return is_on(run, between(run.T_route_start, T_route_vehicle[at]));
    };
    std::size_t first = i;
    while (first < T_route_vehicle.size() && !is_on_run(first)) ++first;
    if (first == T_route_vehicle.size()) continue;
    for (i = first; i < T_route_vehicle.size() && is_on_run(i); ++i) {
    }
    path_segments.push_back({first, i, run.T_route_start.theta});
  }
  return path_segments;
}

/// The path that was driven, settled first by what directions were seen, then by the walls beside its
/// straight segments, too.
std::vector<Pose2> path_of(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                           const SectionLearningParams& params) {
  std::vector<Pose2> T_route_vehicle = settled_path(cycles, vehicle, followed_headings(cycles, vehicle), {});
  if (!goes_anywhere(T_route_vehicle)) return T_route_vehicle;
  std::vector<Run> parts;
  for (const Run& run : runs_of(T_route_vehicle, params)) {
    const std::vector<Run> of_run = parts_of(run, cycles, T_route_vehicle);
    parts.insert(parts.end(), of_run.begin(), of_run.end());
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

/// Leads two segments to the corner where their lines meet.
void lead_to_corner(Run& before, Run& after, const Vec2& gap, double turn_rad) {
  if (std::abs(std::sin(turn_rad)) < kMeetingMin) {
    before.length_m += gap.x();
    return;
  }
  const double back_m = gap.y() / std::sin(turn_rad);
  before.length_m += gap.x() - back_m * std::cos(turn_rad);
  after.T_route_start = after.T_route_start * Pose2{-back_m, 0, 0};
  after.length_m += back_m;
}

/// What lies between two segments: one turn at their corner, or two with a path between.
SectionList joint(Run& before, Run& after, const SectionLearningParams& params) {
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
  const double path_rad = heading_of(gap);
  append_turn(list, round_turn(path_rad));
  list.push_back(straight(gap.norm()));
  append_turn(list, round_turn(wrap_angle(turn_rad - path_rad)));
  return list;
}

/// Distances of the base lines beside a segment, one a cycle that shows them.
struct DistancesBeside {
  struct Distance {
    std::size_t cycle = 0;
    double distance_m = 0;
  };
  std::vector<Distance> right, left;
  std::vector<double> ahead_m;
};

/// From a segment's end to the nearest wall across it; nullopt: none is seen from near.
std::optional<double> distance_ahead(const Run& run, const Pose2& T_run_vehicle,
                                     const std::vector<WallAcross>& across) {
  std::optional<double> nearest_m;
  for (const WallAcross& wall : across) {
    const double ahead_m = wall.along_m - run.length_m;
    const bool is_ahead = ahead_m > kBesideMin_m && wall.along_m - T_run_vehicle.x < kAcrossNear_m;
    if (!is_ahead || wall.from_m > kPathWidth_m || wall.to_m < -kPathWidth_m) continue;
    if (!nearest_m || ahead_m < *nearest_m) nearest_m = ahead_m;
  }
  return nearest_m;
}

DistancesBeside distances_beside(const Run& run, std::span<const SectionCycle> cycles,
                                 const std::vector<Pose2>& T_route_vehicle) {
  DistancesBeside distances;
  std::vector<WallBeside> beside;
  std::vector<WallAcross> across;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Pose2 T_run_vehicle = between(run.T_route_start, T_route_vehicle[i]);
    if (!is_on(run, T_run_vehicle)) continue;
    find_walls_across(cycles[i].floor_edges, T_run_vehicle, across);
    if (const auto ahead_m = distance_ahead(run, T_run_vehicle, across))
      distances.ahead_m.push_back(*ahead_m);
    find_walls_beside(cycles[i].floor_edges, T_run_vehicle, beside);
    double right_m = kBesideMax_m, left_m = kBesideMax_m;
    for (const WallBeside& wall : beside) {
      if (wall.from_m > run.length_m || std::abs(wall.lateral_m) < kBesideMin_m) continue;
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

/// The usual distance of a base line, and in which cycles it was seen there.
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

/// The longest path on which no base line was seen.
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

/// Straight on along the base lines at the distances at which they were seen.
/// @param is_seen  set true for the cycles that show one of them
void append_follow(SectionList& list, const Run& run, std::span<const SectionCycle> cycles,
                   const std::vector<Pose2>& T_route_vehicle, std::vector<bool>& is_seen) {
  const std::vector<Run> parts = parts_of(run, cycles, T_route_vehicle);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const DistancesBeside distances = distances_beside(parts[i], cycles, T_route_vehicle);
    Section section = straight(parts[i].length_m);
    section.right_m = usual(distances.right, is_seen);
    section.left_m = usual(distances.left, is_seen);
    if (i + 1 == parts.size()) section.ahead_m = usual(distances.ahead_m);
    list.push_back(section);
  }
}

/// Where the first segment begins: on its line, unless that lies farther off than a hand wanders. Then the
/// odometry has bent the path, and it begins where the vehicle stood.
Pose2 beginning(const Run& first, const Pose2& T_route_vehicle) {
  const double lateral_m = between(first.T_route_start, T_route_vehicle).y;
  return std::abs(lateral_m) < kOnRun_m ? first.T_route_start : first.T_route_start * Pose2{0, lateral_m, 0};
}

}  // namespace

DrivenList record_drive(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                        const SectionLearningParams& params) {
  DrivenList driven{
      .sections = {}, .corridor_width_m = {}, .T_route_vehicle = path_of(cycles, vehicle, params)};
  if (!goes_anywhere(driven.T_route_vehicle)) return driven;
  std::vector<Run> runs = runs_of(driven.T_route_vehicle, params);
  std::vector<SectionList> joints;
  for (std::size_t i = 1; i < runs.size(); ++i) joints.push_back(joint(runs[i - 1], runs[i], params));
  if (runs.empty()) return driven;
  std::vector<bool> is_seen(cycles.size(), false);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0) driven.sections.insert(driven.sections.end(), joints[i - 1].begin(), joints[i - 1].end());
    if (runs[i].length_m > 0) {
      append_follow(driven.sections, runs[i], cycles, driven.T_route_vehicle, is_seen);
    } else {
      driven.sections.push_back(straight(runs[i].length_m));
    }
  }
  driven.unseen = longest_unseen(is_seen, driven.T_route_vehicle);
  std::vector<double> widths_m;
  for (const Section& section : driven.sections)
    if (section.right_m && section.left_m) widths_m.push_back(*section.right_m + *section.left_m);
  driven.T_route_start = beginning(runs.front(), driven.T_route_vehicle.front());
  if (!widths_m.empty()) driven.corridor_width_m = median(std::move(widths_m));
  return driven;
}

}  // namespace aisle
