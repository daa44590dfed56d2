#include "sections/path_settling.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/cauchy.hpp"
#include "aisle/core/median.hpp"
#include "aisle/core/square.hpp"
#include "aisle/learning/sections/walls_beside.hpp"
#include "aisle/learning/walls/wall_heading.hpp"
#include "odometry_arc.hpp"

namespace aisle {
namespace {

constexpr int kSettlingRounds = 10;
constexpr double kRepeats = 10;        // images in a row that share the same error of an edge
constexpr double kUneven_m = 0.03;     // unevenness of a wall ...
constexpr double kElsewhere_m = 0.05;  // ... an edge that is off by more has less weight
constexpr double kOtherWall_m = 0.5;
constexpr double kWallNear_m = 0.12, kWallFar_m = 3;
constexpr double kSameWall_m = 0.25;        // a wall ahead and one beside, farther apart, are two ...
constexpr double kUnlikelyCorner_m = 0.1;   // ... and from here on less and less likely one
constexpr double kCornerMin = 0.9;          // sine of the turn to a perpendicular segment
constexpr double kFixed_m = 1e-4;           // sigma of what follows from the rest
constexpr double kStart_rad = 5 * kDegree;  // of the first heading against the axes
constexpr double kStill_rad = 0.01 * kDegree;

/// Sparse least squares: many unknowns, few in each equation.
class SparseEquations {
 public:
  explicit SparseEquations(int unknowns) : slope_(Eigen::VectorXd::Zero(unknowns)) {}

  /// @param by  derivatives of the residual by its unknowns
  void add(std::initializer_list<std::pair<int, double>> by, double residual, double sigma) {
    const double weight = 1 / square(sigma);
    for (const auto& [row, by_row] : by) {
      slope_[row] -= weight * by_row * residual;
      for (const auto& [column, by_column] : by)
        entries_.emplace_back(row, column, weight * by_row * by_column);
    }
  }

  Eigen::VectorXd solve() const {
    Eigen::SparseMatrix<double> matrix(slope_.size(), slope_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(slope_);
  }

 private:
  Eigen::VectorXd slope_;
  std::vector<Eigen::Triplet<double>> entries_;
};

std::optional<double> middle_value(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  return median(std::move(values));
}

double place_m(const WallBeside& wall) {
  return wall.lateral_m;
}
double place_m(const WallAcross& wall) {
  return wall.along_m;
}

/// @return nullptr if none is near enough
template <class Wall>
const Wall* nearest_to(double due_m, const std::vector<Wall>& walls, double within_m) {
  const Wall* nearest = nullptr;
  double least_m = within_m;
  for (const Wall& wall : walls) {
    const double off_m = std::abs(place_m(wall) - due_m);
    if (off_m >= least_m) continue;
    least_m = off_m;
    nearest = &wall;
  }
  return nearest;
}

class PathSettler {
 public:
  PathSettler(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
              std::vector<double> headings_rad, std::span<const DrivenPathSegment> path_segments)
      : cycles_(cycles),
        path_segments_(path_segments),
        headings_rad_(std::move(headings_rad)),
        steady_(steady_odometry_sigmas(vehicle)) {
    for (const SectionCycle& cycle : cycles) read_.push_back(uncertain_arc(vehicle, cycle.odometry));
    lay_path();
    walls_m_.resize(path_segments.size());
    for (std::size_t s = 0; s < path_segments.size(); ++s) walls_m_[s] = usual_walls(path_segments[s]);
  }

  /// One round of Gauss-Newton over all cycles.
  void settle() {
    SparseEquations equations(2 + 4 * count() + kSides * static_cast<int>(path_segments_.size()));
    add_odometry(equations);
    add_steps(equations);
    add_directions(equations);
    for (std::size_t s = 0; s < path_segments_.size(); ++s) add_walls(equations, s);
    for (std::size_t s = 0; s + 1 < path_segments_.size(); ++s) add_corner(equations, s);
    for (std::size_t i = 0; i < cycles_.size(); ++i) equations.add({{nod_of_cycle(i), 1}}, 0, 1);
    take(equations.solve());
  }

  std::vector<Pose2> take_path() { return std::move(T_route_vehicle_); }

 private:
  /// Walls of a segment, to its right, to its left and across its end, in the axes: the first two are
  /// measured to its left, the third along it.
  enum Side { kRight, kLeft, kAhead, kSides };
  using Walls = std::array<std::optional<double>, kSides>;

  int count() const { return static_cast<int>(cycles_.size()); }
  static constexpr int kTurnScale = 0, kTurnPerM = 1;
  int heading_of_cycle(std::size_t i) const { return 2 + static_cast<int>(i); }
  int nod_of_cycle(std::size_t i) const { return 2 + count() + static_cast<int>(i); }
  int x_of_cycle(std::size_t i) const { return 2 + 2 * count() + static_cast<int>(i); }
  int y_of_cycle(std::size_t i) const { return 2 + 3 * count() + static_cast<int>(i); }
  /// Relative to where the segment begins.
  int wall_of(std::size_t path_segment, Side side) const {
    return 2 + 4 * count() + kSides * static_cast<int>(path_segment) + side;
  }

  /// The direction in which a wall's position is measured.
  Vec2 normal_of(std::size_t path_segment, Side side) const {
    const Vec2 along = unit(path_segments_[path_segment].heading_rad);
    return side == kAhead ? along : left_normal(along);
  }

  void lay_path() {
    T_route_vehicle_.assign(1, Pose2{0, 0, headings_rad_.front()});
    for (std::size_t i = 1; i < cycles_.size(); ++i) {
      const Arc arc{read_[i].arc.length_m, wrap_angle(headings_rad_[i] - headings_rad_[i - 1])};
      T_route_vehicle_.push_back(T_route_vehicle_.back() * end_pose(arc));
    }
  }

  Pose2 along(const DrivenPathSegment& path_segment, std::size_t i) const {
    return between(Pose2{0, 0, path_segment.heading_rad}, T_route_vehicle_[i]);
  }

  /// Median positions of the nearest walls.
  Walls usual_walls(const DrivenPathSegment& path_segment) {
    std::array<std::vector<double>, kSides> places_m;
    for (std::size_t i = path_segment.first; i < path_segment.end; ++i) {
      const Pose2 T_axis_vehicle = along(path_segment, i);
      find_walls_beside(cycles_[i].floor_edges, T_axis_vehicle, beside_);
      double nearest_right_m = kWallFar_m, nearest_left_m = kWallFar_m;
      for (const WallBeside& wall : beside_) {
        const double off_m = wall.lateral_m - T_axis_vehicle.y;
        if (std::abs(off_m) < kWallNear_m) continue;
        double& nearest_m = off_m < 0 ? nearest_right_m : nearest_left_m;
        nearest_m = std::min(nearest_m, std::abs(off_m));
      }
      if (nearest_right_m < kWallFar_m) places_m[kRight].push_back(T_axis_vehicle.y - nearest_right_m);
      if (nearest_left_m < kWallFar_m) places_m[kLeft].push_back(T_axis_vehicle.y + nearest_left_m);
      find_walls_ahead(i, T_axis_vehicle);
      if (const WallAcross* wall = nearest_to(T_axis_vehicle.x, across_, kAcrossNear_m))
        places_m[kAhead].push_back(wall->along_m);
    }
    Walls walls;
    for (std::size_t side = 0; side < kSides; ++side) walls[side] = middle_value(std::move(places_m[side]));
    return walls;
  }

  /// Finds the walls across the path that are near ahead of the vehicle.
  void find_walls_ahead(std::size_t i, const Pose2& T_axis_vehicle) {
    find_walls_across(cycles_[i].floor_edges, T_axis_vehicle, across_);
    std::erase_if(across_, [&](const WallAcross& wall) {
      const double ahead_m = wall.along_m - T_axis_vehicle.x;
      return ahead_m < kWallNear_m || ahead_m > kAcrossNear_m ||
             wall.from_m - T_axis_vehicle.y > kPathWidth_m || wall.to_m - T_axis_vehicle.y < -kPathWidth_m;
    });
  }

  void add_odometry(SparseEquations& equations) const {
    equations.add({{heading_of_cycle(0), 1}}, headings_rad_.front(), kStart_rad);
    equations.add({{kTurnScale, 1}}, turn_scale_, steady_[1]);
    equations.add({{kTurnPerM, 1}}, turn_per_m_, steady_[2]);
    for (std::size_t i = 1; i < cycles_.size(); ++i) {
      const Arc& arc = read_[i].arc;
      const double turn_rad = arc.turn_rad * (1 + turn_scale_) + arc.length_m * turn_per_m_;
      equations.add({{heading_of_cycle(i), 1},
                     {heading_of_cycle(i - 1), -1},
                     {kTurnScale, -arc.turn_rad},
                     {kTurnPerM, -arc.length_m}},
                    wrap_angle(headings_rad_[i] - headings_rad_[i - 1] - turn_rad),
                    std::hypot(std::sqrt(read_[i].covariance(1, 1)), kStill_rad));
    }
  }

  /// Every edge is parallel to an axis.
  void add_directions(SparseEquations& equations) const {
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
      for (const SensedSegment& edge : cycles_[i].floor_edges) {
        const auto misfit = misfit_to_axis(edge, headings_rad_[i]);
        if (!misfit) continue;
        const double distrust = cauchy_distrust(misfit->off_rad, misfit->usual_rad);
        equations.add({{heading_of_cycle(i), 1}}, misfit->off_rad,
                      std::sqrt(kRepeats) * misfit->sigma_rad * distrust);
      }
    }
  }

  /// Each position follows from the previous one and the motion.
  void add_steps(SparseEquations& equations) const {
    equations.add({{x_of_cycle(0), 1}}, 0, kFixed_m);
    equations.add({{y_of_cycle(0), 1}}, 0, kFixed_m);
    for (std::size_t i = 1; i < cycles_.size(); ++i) {
      const Vec2 by_heading =
          left_normal(T_route_vehicle_[i].position() - T_route_vehicle_[i - 1].position()) / 2;
      const auto add = [&](int now, int before, double by) {
        equations.add({{now, 1}, {before, -1}, {heading_of_cycle(i), -by}, {heading_of_cycle(i - 1), -by}}, 0,
                      kFixed_m);
      };
      add(x_of_cycle(i), x_of_cycle(i - 1), by_heading.x());
      add(y_of_cycle(i), y_of_cycle(i - 1), by_heading.y());
    }
  }

  /// The walls of a segment do not move.
  void add_walls(SparseEquations& equations, std::size_t s) {
    const DrivenPathSegment& path_segment = path_segments_[s];
    for (const Side side : {kRight, kLeft, kAhead}) equations.add({{wall_of(s, side), 1}}, 0, kOtherWall_m);
    for (std::size_t i = path_segment.first; i < path_segment.end; ++i) {
      const Pose2 T_axis_vehicle = along(path_segment, i);
      find_walls_beside(cycles_[i].floor_edges, T_axis_vehicle, beside_);
      add_wall_beside(equations, s, i, kRight);
      add_wall_beside(equations, s, i, kLeft);
      find_walls_ahead(i, T_axis_vehicle);
      add_wall_ahead(equations, s, i);
    }
  }

  void add_wall_beside(SparseEquations& equations, std::size_t s, std::size_t i, Side side) {
    const auto& wall_m = walls_m_[s][side];
    if (!wall_m) return;
    const WallBeside* seen = nearest_to(*wall_m, beside_, kOtherWall_m);
    if (seen == nullptr) return;
    const double heading_rad = T_route_vehicle_[i].theta - path_segments_[s].heading_rad;
    add_wall(equations, s, i, side,
             {.off_m = seen->lateral_m - *wall_m,
              .by_heading = rotate(heading_rad, seen->p_vehicle).x(),
              .by_nod = side == kLeft ? seen->sigma_m : -seen->sigma_m});
  }

  /// The wall's own direction gives its distance, whatever the vehicle's heading.
  void add_wall_ahead(SparseEquations& equations, std::size_t s, std::size_t i) {
    const auto& wall_m = walls_m_[s][kAhead];
    if (!wall_m) return;
    const WallAcross* seen = nearest_to(*wall_m, across_, kOtherWall_m);
    if (seen == nullptr) return;
    add_wall(equations, s, i, kAhead, {.off_m = seen->along_m - *wall_m, .by_nod = seen->sigma_m});
  }

  struct SeenWall {
    double off_m = 0;  ///< from its expected position
    double by_heading = 0, by_nod = 0;
  };

  /// A pitching camera shows all walls too near or too far.
  void add_wall(SparseEquations& equations, std::size_t s, std::size_t i, Side side,
                const SeenWall& seen) const {
    const Vec2 normal = normal_of(s, side);
    const std::size_t first = path_segments_[s].first;
    equations.add({{x_of_cycle(i), normal.x()},
                   {y_of_cycle(i), normal.y()},
                   {x_of_cycle(first), -normal.x()},
                   {y_of_cycle(first), -normal.y()},
                   {heading_of_cycle(i), seen.by_heading},
                   {wall_of(s, side), -1},
                   {nod_of_cycle(i), -seen.by_nod}},
                  seen.off_m, std::sqrt(kRepeats) * kUneven_m * cauchy_distrust(seen.off_m, kElsewhere_m));
  }

  /// The wall across the end of a segment is the one beside the next, on the outer side of the corner.
  void add_corner(SparseEquations& equations, std::size_t s) const {
    const double turn = std::sin(path_segments_[s + 1].heading_rad - path_segments_[s].heading_rad);
    const Side outer = turn > 0 ? kRight : kLeft;
    const auto& ahead_m = walls_m_[s][kAhead];
    const auto& beside_m = walls_m_[s + 1][outer];
    if (std::abs(turn) < kCornerMin || !ahead_m || !beside_m) return;
    const double off_m = *ahead_m + turn * *beside_m;
    if (std::abs(off_m) > kSameWall_m) return;
    const Vec2 along = normal_of(s, kAhead);
    const std::size_t first = path_segments_[s].first, next = path_segments_[s + 1].first;
    equations.add({{wall_of(s, kAhead), 1},
                   {x_of_cycle(first), along.x()},
                   {y_of_cycle(first), along.y()},
                   {wall_of(s + 1, outer), turn},
                   {x_of_cycle(next), -along.x()},
                   {y_of_cycle(next), -along.y()}},
                  off_m, kUneven_m * cauchy_distrust(off_m, kUnlikelyCorner_m));
  }

  /// Walls keep their distances from the start of their segment.
  void take(const Eigen::VectorXd& change) {
    turn_scale_ += change[kTurnScale];
    turn_per_m_ += change[kTurnPerM];
    for (std::size_t i = 0; i < cycles_.size(); ++i)
      headings_rad_[i] = wrap_angle(headings_rad_[i] + change[heading_of_cycle(i)]);
    const std::vector<Pose2> T_route_before = std::exchange(T_route_vehicle_, {});
    lay_path();
    for (std::size_t s = 0; s < path_segments_.size(); ++s) {
      const std::size_t first = path_segments_[s].first;
      const Vec2 moved = T_route_vehicle_[first].position() - T_route_before[first].position();
      for (const Side side : {kRight, kLeft, kAhead})
        if (auto& wall_m = walls_m_[s][side])
          *wall_m += normal_of(s, side).dot(moved) + change[wall_of(s, side)];
    }
  }

  std::span<const SectionCycle> cycles_;
  std::span<const DrivenPathSegment> path_segments_;
  std::vector<double> headings_rad_;
  Vec3 steady_;
  std::vector<UncertainArc> read_;
  std::vector<Walls> walls_m_;
  std::vector<WallBeside> beside_;
  std::vector<WallAcross> across_;
  std::vector<Pose2> T_route_vehicle_;
  double turn_scale_ = 0, turn_per_m_ = 0;
};

}  // namespace

std::vector<Pose2> settled_path(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                                std::vector<double> headings_rad,
                                std::span<const DrivenPathSegment> path_segments) {
  if (cycles.empty()) return {};
  PathSettler settler(cycles, vehicle, std::move(headings_rad), path_segments);
  for (int round = 0; round < kSettlingRounds; ++round) settler.settle();
  return settler.take_path();
}

}  // namespace aisle
