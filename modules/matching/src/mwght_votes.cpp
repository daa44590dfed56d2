#include "mwght_votes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace aisle {
namespace {

constexpr double kWindowRounding = 1e-9;  // a window of whole cells includes the last one
constexpr double kCellsMax = 20'000;      // of half a window

int half_count(double half, double step) {
  const double count = std::floor(half / step + kWindowRounding);
  if (!(count >= 0 && count <= kCellsMax))
    throw std::invalid_argument("a window of MWGHT has 0 to 20,000 cells or angles on each side");
  return static_cast<int>(count);
}

}  // namespace

MwghtGrid::MwghtGrid(const MwghtParams& params, const MwghtWindow& window)
    : half_x(half_count(window.x_half_m, params.cell_m)),
      half_y(half_count(window.y_half_m, params.cell_m)),
      half_turn(half_count(window.turn_half_rad, params.angle_step_rad)) {}

/// Leaves out pairs that reach into the window at no angle: a seen point moves by at most its distance from
/// the origin times the angle.
void MwghtVotes::pair_within_reach(std::span<const WeightedPoint> learned,
                                   std::span<const WeightedPoint> seen, const MwghtGrid& grid, int reach) {
  pairs_.clear();
  for (const WeightedPoint& q : seen) {
    const double turned_m = q.position.norm() * grid.half_turn * params_.angle_step_rad;
    const double x_max_m = (grid.half_x + reach + 1) * params_.cell_m + turned_m;
    const double y_max_m = (grid.half_y + reach + 1) * params_.cell_m + turned_m;
    for (const WeightedPoint& p : learned) {
      const Vec2 between = p.position - q.position;
      if (std::abs(between.x()) > x_max_m || std::abs(between.y()) > y_max_m) continue;
      pairs_.push_back({p.position, q.position, p.weight * q.weight});
    }
  }
}

void MwghtVotes::gather(std::span<const WeightedPoint> learned, std::span<const WeightedPoint> seen,
                        const MwghtGrid& grid, int reach) {
  pair_within_reach(learned, seen, grid, reach);
  votes_.resize(pairs_.size() * static_cast<std::size_t>(grid.turns()));
  first_.clear();
  first_.push_back(0);
  weight_max_ = 0;
  count_max_ = 0;
  for (const Pair& pair : pairs_) weight_max_ = std::max(weight_max_, pair.weight);

  const double cells_per_m = 1 / params_.cell_m;
  const double x_max = grid.columns() - 1 + reach, y_max = grid.rows() - 1 + reach;
  std::size_t count = 0;
  for (int turn = 0; turn < grid.turns(); ++turn) {
    const double angle_rad = (turn - grid.half_turn) * params_.angle_step_rad;
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    for (const Pair& pair : pairs_) {
      const Vec2 &p = pair.p_learned, &q = pair.p_seen;
      const double dx_m = p.x() - (c * q.x() - s * q.y()), dy_m = p.y() - (s * q.x() + c * q.y());  // eq. (5)
      const double x = std::floor(dx_m * cells_per_m + 0.5) + grid.half_x;
      const double y = std::floor(dy_m * cells_per_m + 0.5) + grid.half_y;
      const bool reaches = x >= -reach && x <= x_max && y >= -reach && y <= y_max;
      if (reaches) votes_[count++] = {static_cast<int>(x), static_cast<int>(y), pair.weight};
    }
    count_max_ = std::max(count_max_, count - first_.back());
    first_.push_back(count);
  }
}

}  // namespace aisle
