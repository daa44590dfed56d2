#include "way_settling.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/cauchy.hpp"
#include "aisle/core/median.hpp"
#include "aisle/core/square.hpp"
#include "aisle/learning/wall_heading.hpp"
#include "aisle/learning/walls_beside.hpp"
#include "odometry_arc.hpp"

namespace aisle {
namespace {

constexpr int kSettlings = 10;
constexpr double kRepeats = 10;        // pictures that show the same error of an edge
constexpr double kUneven_m = 0.03;     // of a wall ...
constexpr double kElsewhere_m = 0.05;  // ... and off by more, an edge has less and less say
constexpr double kNarrowing = 0.7;     // of what is off, from one settling to the next
constexpr double kOtherWall_m = 0.5;
constexpr double kWallNear_m = 0.12, kWallFar_m = 3;
constexpr double kFixed_m = 1e-4;           // what follows from the rest
constexpr double kStart_rad = 5 * kDegree;  // against the axes
constexpr double kStill_rad = 0.01 * kDegree;

/// Least squares of many unknowns, few in each equation.
class SparseEquations {
 public:
  explicit SparseEquations(int unknowns) : slope_(Eigen::VectorXd::Zero(unknowns)) {}

  /// @param by  what the residual changes by with each of some unknowns
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

/// @return nullptr if none is near
const WallBeside* nearest_to(double aside_m, const std::vector<WallBeside>& walls) {
  const WallBeside* nearest = nullptr;
  double least_m = kOtherWall_m;
  for (const WallBeside& wall : walls) {
    const double off_m = std::abs(wall.aside_m - aside_m);
    if (off_m >= least_m) continue;
    least_m = off_m;
    nearest = &wall;
  }
  return nearest;
}

class WaySettler {
 public:
  WaySettler(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
             std::vector<double> headings_rad, std::span<const DrivenStretch> stretches)
      : cycles_(cycles),
        stretches_(stretches),
        headings_rad_(std::move(headings_rad)),
        steady_(steady_odometry_sigmas(vehicle)) {
    for (const SectionCycle& cycle : cycles) read_.push_back(uncertain_arc(vehicle, cycle.odometry));
    lay_way();
    walls_m_.resize(stretches.size());
    for (std::size_t s = 0; s < stretches.size(); ++s) walls_m_[s] = usual_walls(stretches[s]);
  }

  /// One round of Gauss-Newton over all cycles.
  /// @param elsewhere_m  an edge that is farther from its wall has less and less say
  void settle(double elsewhere_m) {
    elsewhere_m_ = elsewhere_m;
    SparseEquations equations(2 + 3 * count() + 2 * static_cast<int>(stretches_.size()));
    add_odometry(equations);
    add_directions(equations);
    for (std::size_t s = 0; s < stretches_.size(); ++s) add_walls(equations, s);
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
      equations.add({{aside_of_cycle(i), 1}}, 0, kOtherWall_m);
      equations.add({{nod_of_cycle(i), 1}}, 0, 1);
    }
    take(equations.solve());
  }

  std::vector<Pose2> take_way() { return std::move(T_route_vehicle_); }

 private:
  struct Walls {
    std::optional<double> right_m, left_m;  ///< aside of the stretch, to the left, by the axes
  };

  int count() const { return static_cast<int>(cycles_.size()); }
  static constexpr int kTurnScale = 0, kTurnPerM = 1;
  int heading_of_cycle(std::size_t i) const { return 2 + static_cast<int>(i); }
  int aside_of_cycle(std::size_t i) const { return 2 + count() + static_cast<int>(i); }
  int nod_of_cycle(std::size_t i) const { return 2 + 2 * count() + static_cast<int>(i); }
  int wall_of(std::size_t stretch, bool is_left) const {
    return 2 + 3 * count() + 2 * static_cast<int>(stretch) + (is_left ? 1 : 0);
  }

  void lay_way() {
    T_route_vehicle_.assign(1, Pose2{0, 0, headings_rad_.front()});
    for (std::size_t i = 1; i < cycles_.size(); ++i) {
      const Arc arc{read_[i].arc.length_m, wrap_angle(headings_rad_[i] - headings_rad_[i - 1])};
      T_route_vehicle_.push_back(T_route_vehicle_.back() * end_pose(arc));
    }
  }

  Pose2 along(const DrivenStretch& stretch, std::size_t i) const {
    return between(Pose2{0, 0, stretch.heading_rad}, T_route_vehicle_[i]);
  }

  /// Where the nearest walls are most of the time.
  Walls usual_walls(const DrivenStretch& stretch) {
    std::vector<double> right_m, left_m;
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      const Pose2 T_axis_vehicle = along(stretch, i);
      find_walls_beside(cycles_[i].floor_edges, T_axis_vehicle, beside_);
      double nearest_right_m = kWallFar_m, nearest_left_m = kWallFar_m;
      for (const WallBeside& wall : beside_) {
        const double off_m = wall.aside_m - T_axis_vehicle.y;
        if (std::abs(off_m) < kWallNear_m) continue;
        double& nearest_m = off_m < 0 ? nearest_right_m : nearest_left_m;
        nearest_m = std::min(nearest_m, std::abs(off_m));
      }
      if (nearest_right_m < kWallFar_m) right_m.push_back(T_axis_vehicle.y - nearest_right_m);
      if (nearest_left_m < kWallFar_m) left_m.push_back(T_axis_vehicle.y + nearest_left_m);
    }
    return {middle_value(std::move(right_m)), middle_value(std::move(left_m))};
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

  /// Every edge lies along an axis.
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

  /// The walls beside a stretch stand where they stand.
  void add_walls(SparseEquations& equations, std::size_t s) {
    const DrivenStretch& stretch = stretches_[s];
    for (const bool is_left : {false, true}) equations.add({{wall_of(s, is_left), 1}}, 0, kOtherWall_m);
    equations.add({{aside_of_cycle(stretch.first), 1}}, 0, kFixed_m);
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      if (i > stretch.first) add_step_aside(equations, i);
      const Pose2 T_axis_vehicle = along(stretch, i);
      find_walls_beside(cycles_[i].floor_edges, T_axis_vehicle, beside_);
      if (walls_m_[s].right_m) add_wall(equations, s, i, T_axis_vehicle.theta, false);
      if (walls_m_[s].left_m) add_wall(equations, s, i, T_axis_vehicle.theta, true);
    }
  }

  /// Where the vehicle is follows from where it went.
  void add_step_aside(SparseEquations& equations, std::size_t i) const {
    const double by_heading = -read_[i].arc.length_m / 2;
    equations.add({{aside_of_cycle(i), 1},
                   {aside_of_cycle(i - 1), -1},
                   {heading_of_cycle(i), by_heading},
                   {heading_of_cycle(i - 1), by_heading}},
                  0, kFixed_m);
  }

  /// A camera that nods shows the walls on either side both too near or too far.
  void add_wall(SparseEquations& equations, std::size_t s, std::size_t i, double heading_rad, bool is_left) {
    const double wall_m = is_left ? *walls_m_[s].left_m : *walls_m_[s].right_m;
    const WallBeside* seen = nearest_to(wall_m, beside_);
    if (seen == nullptr) return;
    const double off_m = seen->aside_m - wall_m;
    equations.add({{aside_of_cycle(i), 1},
                   {heading_of_cycle(i), rotate(heading_rad, seen->p_vehicle).x()},
                   {wall_of(s, is_left), -1},
                   {nod_of_cycle(i), is_left ? -seen->sigma_m : seen->sigma_m}},
                  off_m, std::sqrt(kRepeats) * kUneven_m * cauchy_distrust(off_m, elsewhere_m_));
  }

  /// The walls keep their distances from where their stretch begins.
  void take(const Eigen::VectorXd& change) {
    turn_scale_ += change[kTurnScale];
    turn_per_m_ += change[kTurnPerM];
    for (std::size_t i = 0; i < cycles_.size(); ++i)
      headings_rad_[i] = wrap_angle(headings_rad_[i] + change[heading_of_cycle(i)]);
    const std::vector<Pose2> T_route_before = std::exchange(T_route_vehicle_, {});
    lay_way();
    for (std::size_t s = 0; s < stretches_.size(); ++s) {
      const std::size_t first = stretches_[s].first;
      const Vec2 moved = T_route_vehicle_[first].position() - T_route_before[first].position();
      const double aside_m = rotate(-stretches_[s].heading_rad, moved).y();
      if (walls_m_[s].right_m) *walls_m_[s].right_m += aside_m + change[wall_of(s, false)];
      if (walls_m_[s].left_m) *walls_m_[s].left_m += aside_m + change[wall_of(s, true)];
    }
  }

  std::span<const SectionCycle> cycles_;
  std::span<const DrivenStretch> stretches_;
  std::vector<double> headings_rad_;
  Vec3 steady_;
  std::vector<UncertainArc> read_;
  std::vector<Walls> walls_m_;
  std::vector<WallBeside> beside_;
  std::vector<Pose2> T_route_vehicle_;
  double turn_scale_ = 0, turn_per_m_ = 0;
  double elsewhere_m_ = kElsewhere_m;
};

}  // namespace

std::vector<Pose2> settled_way(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                               std::vector<double> headings_rad, std::span<const DrivenStretch> stretches) {
  if (cycles.empty()) return {};
  WaySettler settler(cycles, vehicle, std::move(headings_rad), stretches);
  for (int round = 0; round < kSettlings; ++round)
    settler.settle(std::max(kElsewhere_m, kOtherWall_m * std::pow(kNarrowing, round)));
  return settler.take_way();
}

}  // namespace aisle
